namespace UnityEngine.Rendering;

public sealed class GraphicsSettings : Object
{
    GraphicsSettings()
    {
    }

    public static RenderPipelineAsset currentRenderPipeline => World.Current.Gpu.RenderPipeline;
}

public abstract class RenderPipelineAsset : ScriptableObject
{
}
