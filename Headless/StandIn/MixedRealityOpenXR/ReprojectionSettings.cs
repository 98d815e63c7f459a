using UnityEngine;

namespace Microsoft.MixedReality.OpenXR;

public struct ReprojectionSettings
{
    ReprojectionMode? _mode;

    public Vector3? ReprojectionPlaneOverridePosition;
    public Vector3? ReprojectionPlaneOverrideNormal;
    public Vector3? ReprojectionPlaneOverrideVelocity;

    public ReprojectionMode ReprojectionMode
    {
        get => _mode ?? ReprojectionMode.Depth;
        set => _mode = value;
    }
}

public enum ReprojectionMode
{
    Depth = 1,
    PlanarFromDepth = 2,
    PlanarManual = 3,
    OrientationOnly = 4,
    NoReprojection = -1,
}
