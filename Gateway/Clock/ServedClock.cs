using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>The clock that the gateway serves as C1: the control system's clock if an adapter offers it, otherwise the gateway's own.</summary>
/// <remarks>
/// While the selected clock of the control system has never been known, the gateway's own clock is served, marked as not synchronised. A
/// clock that was lost for so long that its bound exceeds a headset's holdover limit is still served, marked as not synchronised. The
/// served clock is continuous, so its resolution is that of the time types. The resolution of the plant's clock is part of the bound.
/// </remarks>
public sealed class ServedClock : IControlClock
{
    readonly IControlClock _own;
    readonly PlantClocks _plant;

    /// <param name="system">System clock and counter, for the comparison with stamps; null for those of this machine.</param>
    internal ServedClock(IControlClock own, PlantClocks plant, TimeProvider system = null)
    {
        _own = own;
        _plant = plant;
        system ??= TimeProvider.System;
        var systemClock = new SystemControlClock(system);
        var (start, count) = (systemClock.Now, system.GetTimestamp());
        var isSystemServed = own is SystemControlClock;
        Stamps = new StampWatch(
            () => Now, () => Known == null ? PlantClocks.Own : Source, () => ErrorBound, () => _plant.Control == null ? _own : null,
            isSystemServed ? () => start + system.GetElapsedTime(count) : () => systemClock.Now, isSystemServed, system);
    }

    /// <summary>Compares the stamps of sources with this clock.</summary>
    internal StampWatch Stamps { get; }

    /// <summary>Name of the plant's clock that is C1; <see cref="PlantClocks.Own"/> for the gateway's own.</summary>
    public string Source => _plant.Control?.Name ?? PlantClocks.Own;

    public ControlTime Now => Known is { } model ? model.ToControl(_plant.Counter.Now) : _own.Now;
    public TimeSpan ErrorBound => Known?.ErrorBound ?? _own.ErrorBound;
    public bool IsSynchronised => _plant.Control is { } control ? ClockSettings.Default.Trusts(control.Model) : _own.IsSynchronised;
    public TimeSpan Resolution => Known == null ? _own.Resolution : new TimeSpan(1);
    public double Skew => -Known?.Skew ?? _own.Skew;

    // Null while the gateway's own clock is served, which includes the time in which the selected clock is unknown.
    ClockModel? Known => _plant.Control?.Model is { IsKnown: true } model ? model : null;

    /// <summary>State of C1. The gateway's own clock is synchronised, or converging if it is not synchronised with its reference.</summary>
    public ClockState State => _plant.Control?.Model.State ?? (_own.IsSynchronised ? ClockState.Synchronised : ClockState.Converging);

    /// <summary>Converts a time of a plant's clock to C1.</summary>
    /// <param name="from">The plant's clock; null for a time that is already on C1.</param>
    /// <returns>False while either clock is unknown, or the plant's clock is no longer accurate enough.</returns>
    public bool TryMap(PlantClock from, ControlTime time, out ControlTime onControl)
    {
        onControl = time;
        if (from == null) return true;
        var model = from.Model;
        if (from == _plant.Control) return model.IsKnown;
        var now = _plant.Counter.Now;
        if (!ClockSettings.Default.Trusts(model) || OffsetToControl(model, now) is not { } ahead || !IsNear(time, model.ToControl(now))) return false;
        // Uses the current difference. Stamps are at most a second old. In a second, two clocks diverge by microseconds.
        onControl = time - ahead;
        return true;
    }

    /// <summary>Gets the status of all clocks of the plant.</summary>
    public IReadOnlyList<PlantClockStatus> Status()
    {
        var now = _plant.Counter.Now;
        return [.. _plant.All.Select(clock => StatusOf(clock, now))];
    }

    PlantClockStatus StatusOf(PlantClock clock, HeadsetTime now)
    {
        var model = clock.Model;
        var ahead = OffsetToControl(model, now);
        return new PlantClockStatus(
            clock.Name, clock.IsConnected, clock == _plant.Control, model.State, ahead, ahead == null ? null : (-model.Skew - Skew) * 1e6,
            clock.RoundTripTime, model.IsKnown ? model.EstimatedError : null, model.ErrorBound, clock.Resolution, clock.Exchanges, clock.Failures, clock.LastFailure);
    }

    TimeSpan? OffsetToControl(in ClockModel model, HeadsetTime now)
    {
        if (!model.IsKnown || _plant.Control?.Model.IsKnown == false) return null;
        var control = _plant.Control is { } plant ? plant.Model.ToControl(now) : _own.Now;
        return model.ToControl(now) - control;
    }

    // A stamp of another century minus an offset may overflow the types, and is not from this clock.
    static bool IsNear(ControlTime stamp, ControlTime now) =>
        Math.Abs((decimal)stamp.SinceEpoch.Ticks - now.SinceEpoch.Ticks) < (decimal)TimeSpan.TicksPerDay * 36500;
}
