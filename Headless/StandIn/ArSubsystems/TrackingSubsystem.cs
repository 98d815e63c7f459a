using System.Collections.Generic;
using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public abstract class TrackingSubsystem<TTrackable, TSubsystem, TSubsystemDescriptor, TProvider>
    : SubsystemWithProvider<TSubsystem, TSubsystemDescriptor, TProvider>
    where TTrackable : struct, ITrackable
    where TSubsystem : SubsystemWithProvider, new()
    where TSubsystemDescriptor : SubsystemDescriptorWithProvider
    where TProvider : SubsystemProvider<TSubsystem>
{
    /// <summary>Trackables that the device has added or changed since the last query.</summary>
    internal List<TTrackable> Changed { get; } = new();

    internal List<TrackableId> Removed { get; } = new();

    internal void Report(TTrackable trackable) => Changed.Add(trackable);

    internal void Remove(TrackableId id) => Removed.Add(id);
}
