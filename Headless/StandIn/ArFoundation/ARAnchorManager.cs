using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[DefaultExecutionOrder(int.MinValue + 1)]
public sealed class ARAnchorManager : ARTrackableManager<
    XRAnchorSubsystem, XRAnchorSubsystemDescriptor, XRAnchorSubsystem.Provider, XRAnchor, ARAnchor>
{
    internal static ARAnchorManager Instance => (ARAnchorManager)Latest;

    internal bool TryAdd(ARAnchor anchor)
    {
        if (anchor.trackableId != TrackableId.invalidId) return false;
        if (!enabled || subsystem == null)
        {
            anchor.pending = true;
            return false;
        }
        if (!subsystem.TryAddAnchor(SessionPoseOf(anchor.transform), out var data)) return false;

        Adopt(anchor, data);
        return true;
    }

    internal void Remove(ARAnchor anchor)
    {
        subsystem?.TryRemoveAnchor(anchor.trackableId);
        anchor.pending = false;
    }
}
