namespace UnityEngine;

public enum CameraClearFlags
{
    Skybox = 1,
    SolidColor = 2,
}
