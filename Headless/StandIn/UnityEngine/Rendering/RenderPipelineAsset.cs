namespace UnityEngine.Rendering;

public abstract class RenderPipelineAsset : ScriptableObject
{
}
