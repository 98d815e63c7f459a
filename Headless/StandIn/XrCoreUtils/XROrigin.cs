using UnityEngine;

namespace Unity.XR.CoreUtils;

[AddComponentMenu("XR/XR Origin")]
[DisallowMultipleComponent]
public class XROrigin : MonoBehaviour
{
    [SerializeField] Camera m_Camera;
    [SerializeField] GameObject m_OriginBaseGameObject;
    [SerializeField] GameObject m_CameraFloorOffsetObject;

    public Camera Camera
    {
        get => m_Camera;
        set => m_Camera = value;
    }

    public GameObject Origin
    {
        get => m_OriginBaseGameObject;
        set => m_OriginBaseGameObject = value;
    }

    public GameObject CameraFloorOffsetObject
    {
        get => m_CameraFloorOffsetObject;
        set => m_CameraFloorOffsetObject = value;
    }

    public Transform TrackablesParent { get; private set; }

    protected void Awake()
    {
        TrackablesParent = new GameObject("Trackables").transform;
        TrackablesParent.SetParent(transform, false);
    }
}
