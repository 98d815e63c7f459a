namespace Microsoft.MixedReality.OpenXR;

public enum TransformMode
{
    MostStable = 0,
    Center = 1,
}
