using System;
using System.Collections.Generic;

namespace UnityEngine.XR.ARSubsystems;

/// <summary>The device that a test plays: which subsystems its runtime offers. One at a time; without one there are none.</summary>
sealed class ArDevice : IDisposable
{
    readonly List<object> _subsystems = new();

    internal ArDevice() => Current = this;

    internal static ArDevice Current { get; private set; }

    /// <summary>What <c>ARSession.state</c> says, as its number; 0 is None, 7 SessionTracking.</summary>
    internal int SessionState { get; set; } = 7;

    /// <summary>The runtime offers it to managers that are enabled from now on.</summary>
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
