using System.Collections.Generic;
using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public class XRAnchorSubsystem : TrackingSubsystem<XRAnchor, XRAnchorSubsystem, XRAnchorSubsystemDescriptor, XRAnchorSubsystem.Provider>
{
    static ulong s_subsystems;

    readonly Dictionary<TrackableId, XRAnchor> _anchors = new();

    // Ids differ between subsystems, also after a restart.
    readonly ulong _number = ++s_subsystems;

    /// <summary>Whether the device accepts anchors.</summary>
    internal bool Accepts { get; set; } = true;

    internal int Count => _anchors.Count;

    public bool TryAddAnchor(Pose pose, out XRAnchor anchor)
    {
        anchor = default;
        if (!Accepts) return false;

        anchor = new XRAnchor(new TrackableId(_number, (ulong)_anchors.Count + 1), pose, TrackingState.Tracking);
        _anchors.Add(anchor.trackableId, anchor);
        Report(anchor);
        return true;
    }

    public bool TryRemoveAnchor(TrackableId anchorId)
    {
        if (!_anchors.Remove(anchorId)) return false;

        Remove(anchorId);
        return true;
    }

    /// <summary>Sets the pose and state of an anchor. Simulates a correction of the device's map, the loss of the map, or a loaded anchor.</summary>
    internal void Place(TrackableId id, Pose pose, TrackingState state)
    {
        _anchors[id] = new XRAnchor(id, pose, state);
        Report(_anchors[id]);
    }

    public abstract class Provider : SubsystemProvider<XRAnchorSubsystem>
    {
    }
}
