using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[DefaultExecutionOrder(int.MinValue + 2)]
[DisallowMultipleComponent]
public sealed class ARAnchor : ARTrackable<XRAnchor, ARAnchor>
{
    void OnEnable()
    {
        if (ARAnchorManager.Instance) ARAnchorManager.Instance.TryAdd(this);
        else pending = true;
    }

    void Update()
    {
        if (trackableId == TrackableId.invalidId && ARAnchorManager.Instance) ARAnchorManager.Instance.TryAdd(this);
    }

    void OnDisable()
    {
        if (ARAnchorManager.Instance) ARAnchorManager.Instance.Remove(this);
    }
}
