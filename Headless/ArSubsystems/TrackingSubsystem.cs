using System.Collections.Generic;
using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public abstract class TrackingSubsystem<TTrackable, TSubsystem, TSubsystemDescriptor, TProvider>
    : SubsystemWithProvider<TSubsystem, TSubsystemDescriptor, TProvider>, ITrackingDevice<TTrackable>
    where TTrackable : struct, ITrackable
    where TSubsystem : SubsystemWithProvider, new()
    where TSubsystemDescriptor : SubsystemDescriptorWithProvider
    where TProvider : SubsystemProvider<TSubsystem>
{
    readonly List<TTrackable> _changed = new();
    readonly List<TrackableId> _removed = new();

    /// <summary>What the device tells with the next update of its manager.</summary>
    internal void Report(TTrackable trackable) => _changed.Add(trackable);

    internal void Remove(TrackableId id) => _removed.Add(id);

    List<TTrackable> ITrackingDevice<TTrackable>.Changed => _changed;

    List<TrackableId> ITrackingDevice<TTrackable>.Removed => _removed;
}
