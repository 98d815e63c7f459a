using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class Camera : Behaviour
{
    public static CameraCallback onPreRender;
    public static CameraCallback onPostRender;

    [field: SerializeField, SerializedName("near clip plane")] public float nearClipPlane { get; set; } = 0.3f;
    [field: SerializeField, SerializedName("far clip plane")] public float farClipPlane { get; set; } = 1000;

    /// <summary>Vertical field of view in degrees.</summary>
    [field: SerializeField, SerializedName("field of view")] public float fieldOfView { get; set; } = 60;
    [SerializeField, SerializedName("orthographic")] bool _orthographic;
    [SerializeField, SerializedName("orthographic size")] float _orthographicSize = 5;
    [field: SerializeField, SerializedName("m_Depth")] public float depth { get; set; }
    [field: SerializeField, SerializedName("m_ClearFlags")] public CameraClearFlags clearFlags { get; set; } = CameraClearFlags.Skybox;
    [field: SerializeField, SerializedName("m_BackGroundColor")] public Color backgroundColor { get; set; } = new(0.19f, 0.3f, 0.47f, 0);
    [SerializeField, SerializedName("m_CullingMask")] int _cullingMask = -1;

    public delegate void CameraCallback(Camera cam);

    /// <summary>The first enabled camera with the tag MainCamera.</summary>
    public static Camera main => World.Current.Cameras.Main;

    internal override void StartRunning() => World.Cameras.Add(this);

    internal override void StopRunning() => World.Cameras.Remove(this);
}

public enum CameraClearFlags
{
    Skybox = 1,
    SolidColor = 2,
}
