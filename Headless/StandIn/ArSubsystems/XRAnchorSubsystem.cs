using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public class XRAnchorSubsystem : TrackingSubsystem<XRAnchor, XRAnchorSubsystem, XRAnchorSubsystemDescriptor, XRAnchorSubsystem.Provider>
{
    static ulong s_subsystems;

    readonly Dictionary<TrackableId, XRAnchor> _anchors = new();
    readonly Queue<(Pose Pose, Awaitable<Result<XRAnchor>> Response)> _requests = new();

    // Ids differ between subsystems, also after a restart.
    readonly ulong _number = ++s_subsystems;

    /// <summary>Whether the device accepts anchors.</summary>
    internal bool Accepts { get; set; } = true;

    /// <summary>
    /// Whether the device creates anchors only asynchronously, as a Quest with AR Foundation 6. <see cref="Respond"/> then creates them.
    /// </summary>
    internal bool IsAsynchronous { get; set; }

    internal int Count => _anchors.Count;

    /// <summary>Number of asynchronous requests without a response.</summary>
    internal int RequestCount => _requests.Count;

    public bool TryAddAnchor(Pose pose, out XRAnchor anchor)
    {
        anchor = default;
        return !IsAsynchronous && Add(pose, out anchor);
    }

    public Awaitable<Result<XRAnchor>> TryAddAnchorAsync(Pose pose)
    {
        var response = new Awaitable<Result<XRAnchor>>();
        _requests.Enqueue((pose, response));
        if (!IsAsynchronous) Respond();
        return response;
    }

    /// <summary>Responds to all asynchronous requests.</summary>
    /// <param name="fault">Exception with which the requests end; null if the device responds with a result.</param>
    internal void Respond(Exception fault = null)
    {
        while (_requests.TryDequeue(out var request))
        {
            if (fault != null) request.Response.SetException(fault);
            else request.Response.SetResult(new Result<XRAnchor>(new XRResultStatus(Add(request.Pose, out var anchor)), anchor));
        }
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

    bool Add(Pose pose, out XRAnchor anchor)
    {
        anchor = default;
        if (!Accepts) return false;

        anchor = new XRAnchor(new TrackableId(_number, (ulong)_anchors.Count + 1), pose, TrackingState.Tracking);
        _anchors.Add(anchor.trackableId, anchor);
        Report(anchor);
        return true;
    }

    public abstract class Provider : SubsystemProvider<XRAnchorSubsystem>
    {
    }
}

public class XRAnchorSubsystemDescriptor : SubsystemDescriptorWithProvider<XRAnchorSubsystem, XRAnchorSubsystem.Provider>
{
}
