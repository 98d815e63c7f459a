using UnityEngine;

namespace Unity.XR.CoreUtils;

[AddComponentMenu("XR/XR Origin")]
[DisallowMultipleComponent]
public class XROrigin : MonoBehaviour
{
    [SerializeField] Camera m_Camera;
    [SerializeField] GameObject m_OriginBaseGameObject;
    [SerializeField] GameObject m_CameraFloorOffsetObject;

    public Transform TrackablesParent { get; private set; }

    protected void Awake()
    {
        TrackablesParent = new GameObject("Trackables").transform;
        TrackablesParent.SetParent(transform, false);
    }
}
