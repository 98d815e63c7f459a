using System;
using System.Collections.Generic;

namespace UnityEngine.XR.ARSubsystems;

/// <summary>The simulated device of a test, with the subsystems that its runtime offers. At most one exists at a time.</summary>
sealed class ArDevice : IDisposable
{
    readonly List<object> _subsystems = new();

    internal ArDevice() => Current = this;

    internal static ArDevice Current { get; private set; }

    /// <summary>The value of <c>ARSession.state</c> as a number; 0 is None, 7 is SessionTracking.</summary>
    internal int SessionState { get; set; } = 7;

    /// <summary>Makes the runtime offer a subsystem to managers that are enabled from now on.</summary>
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
