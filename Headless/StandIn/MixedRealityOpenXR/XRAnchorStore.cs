using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Microsoft.MixedReality.OpenXR;

public class XRAnchorStore
{
    readonly Dictionary<string, TrackableId> _kept = new();
    readonly List<string> _names = new();

    internal XRAnchorStore()
    {
    }

    /// <summary>Function with which the simulated runtime loads the store. It returns null if the runtime has no store.</summary>
    internal static Func<XRAnchorSubsystem, Task<XRAnchorStore>> Loading { get; set; } = _ => Task.FromResult<XRAnchorStore>(null);

    public IReadOnlyList<string> PersistedAnchorNames => Fault == null ? _names : throw Fault;

    /// <summary>Whether the store accepts anchors.</summary>
    internal bool Accepts { get; set; } = true;

    /// <summary>Name under which the store accepts no anchor; null for none.</summary>
    internal string RefusedName { get; set; }

    /// <summary>Exception that each call throws; null if calls succeed.</summary>
    internal Exception Fault { get; set; }

    /// <summary>Adds an anchor, as if an earlier run of the application had saved it.</summary>
    internal void Put(string name, TrackableId id)
    {
        _kept[name] = id;
        if (!_names.Contains(name)) _names.Add(name);
    }

    internal TrackableId KeptAs(string name) => _kept.TryGetValue(name, out var id) ? id : TrackableId.invalidId;

    public TrackableId LoadAnchor(string name) => Fault == null ? KeptAs(name) : throw Fault;

    public bool TryPersistAnchor(TrackableId trackableId, string name)
    {
        if (Fault != null) throw Fault;
        if (!Accepts || name == RefusedName || _kept.ContainsKey(name)) return false;

        Put(name, trackableId);
        return true;
    }

    public void UnpersistAnchor(string name)
    {
        if (Fault != null) throw Fault;

        _kept.Remove(name);
        _names.Remove(name);
    }
}
