using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class Camera : Behaviour
{
    public static CameraCallback onPreRender;
    public static CameraCallback onPostRender;

    [SerializeField, SerializedName("near clip plane")] float _near = 0.3f;
    [SerializeField, SerializedName("far clip plane")] float _far = 1000;
    [SerializeField, SerializedName("field of view")] float _fieldOfView = 60;
    [SerializeField, SerializedName("orthographic")] bool _orthographic;
    [SerializeField, SerializedName("orthographic size")] float _orthographicSize = 5;
    [SerializeField, SerializedName("m_Depth")] float _depth;
    [SerializeField, SerializedName("m_ClearFlags")] CameraClearFlags _clearFlags = CameraClearFlags.Skybox;
    [SerializeField, SerializedName("m_BackGroundColor")] Color _backgroundColor = new(0.19f, 0.3f, 0.47f, 0);
    [SerializeField, SerializedName("m_CullingMask")] int _cullingMask = -1;

    public delegate void CameraCallback(Camera cam);

    /// <summary>The first enabled camera with the tag MainCamera.</summary>
    public static Camera main => World.Current.Cameras.Main;

    public float nearClipPlane
    {
        get => _near;
        set => _near = value;
    }

    public float farClipPlane
    {
        get => _far;
        set => _far = value;
    }

    /// <summary>Vertical field of view in degrees.</summary>
    public float fieldOfView
    {
        get => _fieldOfView;
        set => _fieldOfView = value;
    }

    public float depth
    {
        get => _depth;
        set => _depth = value;
    }

    public CameraClearFlags clearFlags
    {
        get => _clearFlags;
        set => _clearFlags = value;
    }

    public Color backgroundColor
    {
        get => _backgroundColor;
        set => _backgroundColor = value;
    }

    internal override void StartRunning() => World.Cameras.Add(this);

    internal override void StopRunning() => World.Cameras.Remove(this);
}
