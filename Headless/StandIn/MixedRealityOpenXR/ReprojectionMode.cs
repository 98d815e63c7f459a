namespace Microsoft.MixedReality.OpenXR;

public enum ReprojectionMode
{
    Depth = 1,
    PlanarFromDepth = 2,
    PlanarManual = 3,
    OrientationOnly = 4,
    NoReprojection = -1,
}
