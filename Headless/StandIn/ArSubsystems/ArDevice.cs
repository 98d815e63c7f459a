namespace UnityEngine.XR.ARSubsystems;

/// <summary>A simulated device with the subsystems that its runtime provides. At most one device exists at a time.</summary>
sealed class ArDevice : IDisposable
{
    readonly List<object> _subsystems = new();

    internal ArDevice() => Current = this;

    internal static ArDevice Current { get; private set; }

    /// <summary>Installed version of AR Foundation. The managers' behaviour depends on it.</summary>
    internal Version ArFoundation { get; set; } = new(6, 2);

    /// <summary>Value of <c>ARSession.state</c> as a number, for example 0 for None and 7 for SessionTracking.</summary>
    internal int SessionState { get; set; } = 7;

    /// <summary>Adds a subsystem to the runtime. Managers that are enabled later find it.</summary>
    internal T Offer<T>() where T : class, new()
    {
        var subsystem = new T();
        _subsystems.Add(subsystem);
        return subsystem;
    }

    internal T Find<T>() where T : class
    {
        foreach (var subsystem in _subsystems)
            if (subsystem is T found) return found;
        return null;
    }

    public void Dispose()
    {
        if (Current == this) Current = null;
    }
}
