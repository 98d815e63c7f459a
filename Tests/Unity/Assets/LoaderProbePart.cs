#pragma warning disable CA1051 // Unity serialises public fields.
namespace Nowpose.Unity.Tests.Assets;

[Serializable]
public sealed class LoaderProbePart
{
    public string name = "";
    public float size = 0.5f;
    public UnityEngine.Transform where;
}
