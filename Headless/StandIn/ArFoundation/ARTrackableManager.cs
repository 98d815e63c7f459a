using Unity.XR.CoreUtils;
using UnityEngine.SubsystemsImplementation;
using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[RequireComponent(typeof(XROrigin))]
[DisallowMultipleComponent]
public abstract class ARTrackableManager<TSubsystem, TSubsystemDescriptor, TProvider, TSessionRelativeData, TTrackable>
    : SubsystemLifecycleManager<TSubsystem, TSubsystemDescriptor, TProvider>
    where TSubsystem : TrackingSubsystem<TSessionRelativeData, TSubsystem, TSubsystemDescriptor, TProvider>, new()
    where TSubsystemDescriptor : SubsystemDescriptorWithProvider<TSubsystem, TProvider>
    where TProvider : SubsystemProvider<TSubsystem>
    where TSessionRelativeData : struct, ITrackable
    where TTrackable : ARTrackable<TSessionRelativeData, TTrackable>
{
    protected Dictionary<TrackableId, TTrackable> m_Trackables = new();

    public TrackableCollection<TTrackable> trackables => new(m_Trackables);

    protected XROrigin origin { get; private set; }

    /// <summary>The manager of this type that was enabled most recently.</summary>
    internal static ARTrackableManager<TSubsystem, TSubsystemDescriptor, TProvider, TSessionRelativeData, TTrackable> Latest { get; private set; }

    protected virtual void Awake() => origin = GetComponent<XROrigin>();

    protected override void OnEnable()
    {
        base.OnEnable();
        Latest = this;
    }

    protected virtual void Update()
    {
        if (subsystem == null || !subsystem.running) return;

        foreach (var added in subsystem.Added) Add(added);
        subsystem.Added.Clear();
        foreach (var updated in subsystem.Updated) CreateOrUpdate(updated);
        subsystem.Updated.Clear();
        foreach (var removed in subsystem.Removed)
            if (m_Trackables.Remove(removed, out var trackable) && trackable) Destroy(trackable.gameObject);
        subsystem.Removed.Clear();
    }

    /// <summary>Registers a component that a script has added as a trackable of the device. It is pending until the device reports it.</summary>
    internal void Adopt(TTrackable trackable, TSessionRelativeData data)
    {
        m_Trackables.Add(data.trackableId, trackable);
        trackable.Set(data, origin.TrackablesParent);
        trackable.pending = true;
    }

    internal Pose SessionPoseOf(Transform place)
    {
        var parent = origin.TrackablesParent;
        return new Pose(parent.InverseTransformPoint(place.position), Quaternion.Inverse(parent.rotation) * place.rotation);
    }

    internal virtual void OnUpdated(TTrackable trackable, TSessionRelativeData data)
    {
    }

    void Add(TSessionRelativeData data)
    {
        if (Version6.IgnoresAddedComponents) OnUpdated(Create(data), data);
        else CreateOrUpdate(data);
    }

    void CreateOrUpdate(TSessionRelativeData data)
    {
        if (!m_Trackables.TryGetValue(data.trackableId, out var trackable)) trackable = Create(data);
        trackable.pending = false;
        trackable.Set(data, origin.TrackablesParent);
        OnUpdated(trackable, data);
    }

    TTrackable Create(TSessionRelativeData data)
    {
        var place = new GameObject(typeof(TTrackable).Name + " " + data.trackableId);
        place.SetActive(false);
        place.transform.SetParent(origin.TrackablesParent, false);
        var trackable = place.AddComponent<TTrackable>();
        m_Trackables[data.trackableId] = trackable;
        trackable.Set(data, origin.TrackablesParent);
        place.SetActive(true);
        return trackable;
    }
}
