using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[DefaultExecutionOrder(int.MinValue + 2)]
[DisallowMultipleComponent]
public sealed class ARAnchor : ARTrackable<XRAnchor, ARAnchor>
{
    void OnEnable()
    {
        var manager = ARAnchorManager.Instance;
        if (!manager) pending = true;
        // Since version 6, an anchor that the device refuses disables itself.
        else if (trackableId == TrackableId.invalidId && !manager.TryAdd(this) && Version6.IsInstalled) enabled = false;
    }

    void Update()
    {
        if (!Version6.IsInstalled && trackableId == TrackableId.invalidId && ARAnchorManager.Instance) ARAnchorManager.Instance.TryAdd(this);
    }

    void OnDisable()
    {
        if (ARAnchorManager.Instance) ARAnchorManager.Instance.Remove(this);
    }
}
