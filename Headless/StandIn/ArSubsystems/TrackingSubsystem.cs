using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public abstract class TrackingSubsystem<TTrackable, TSubsystem, TSubsystemDescriptor, TProvider>
    : SubsystemWithProvider<TSubsystem, TSubsystemDescriptor, TProvider>
    where TTrackable : struct, ITrackable
    where TSubsystem : SubsystemWithProvider, new()
    where TSubsystemDescriptor : SubsystemDescriptorWithProvider
    where TProvider : SubsystemProvider<TSubsystem>
{
    readonly HashSet<TrackableId> _reported = new();

    /// <summary>Trackables that the device has added since the last query.</summary>
    internal List<TTrackable> Added { get; } = new();

    /// <summary>Trackables that the device has changed since the last query.</summary>
    internal List<TTrackable> Updated { get; } = new();

    internal List<TrackableId> Removed { get; } = new();

    internal void Report(TTrackable trackable) => (_reported.Add(trackable.trackableId) ? Added : Updated).Add(trackable);

    internal void Remove(TrackableId id)
    {
        _reported.Remove(id);
        Removed.Add(id);
    }
}
