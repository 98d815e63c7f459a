using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>The clock that the gateway serves as C1: the control system's clock if an adapter offers it, otherwise the gateway's own.</summary>
/// <remarks>
/// Until the first estimate of the selected clock exists, the gateway serves its own clock, marked as not synchronised. After the selected
/// clock is lost, the gateway continues to serve its estimate, marked as not synchronised once the error bound exceeds a headset's
/// holdover limit. The estimate is continuous, so its resolution is that of the time types; the resolution of the plant's clock is part of
/// the error bound.
/// </remarks>
public sealed class ServedClock : IControlClock
{
    readonly IControlClock _own;
    readonly PlantClocks _plant;

    /// <param name="system">System clock and counter with which stamps are compared; null for those of this machine.</param>
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

    /// <summary>The comparison of the sources' stamps with this clock.</summary>
    internal StampWatch Stamps { get; }

    /// <summary>Name of the plant's clock that is C1; <see cref="PlantClocks.Own"/> if C1 is the gateway's own clock.</summary>
    public string Source => _plant.Control?.Name ?? PlantClocks.Own;

    /// <summary>Whether C1 is a plant's clock that no adapter has offered since the gateway started.</summary>
    internal bool IsNotOffered => _plant.Control is { IsConnected: false, Exchanges: 0, Failures: 0 };

    /// <summary>Rate of C1 if it is a plant's clock with a wrong rate; null otherwise.</summary>
    internal double? WrongRate => _plant.Control?.WrongRate;

    /// <summary>The clients that offer a clock under the name of a served one, with another time.</summary>
    internal IEnumerable<ClockContradiction> Contradictions => _plant.All.SelectMany(clock => clock.Contradictions);

    public ControlTime Now => Known is { } model ? model.ToControl(_plant.Counter.Now) : _own.Now;
    public TimeSpan ErrorBound => Known?.ErrorBound ?? _own.ErrorBound;
    public bool IsSynchronised => _plant.Control is { } control ? ClockSettings.Default.Trusts(control.Model) : _own.IsSynchronised;
    public TimeSpan Resolution => Known == null ? _own.Resolution : new TimeSpan(1);
    public double Skew => -Known?.Skew ?? _own.Skew;

    /// <summary>Gets the clock's time when this machine's counter had a count, at the current offset.</summary>
    /// <remarks>
    /// The counter is read before the clock. An interruption between the two makes the result late, not early, so a message stamped by
    /// this clock never seems to arrive before it was sent.
    /// </remarks>
    public ControlTime AtReceived(long count)
    {
        var elapsed = _plant.Counter.Now - _plant.Counter.At(count);
        return Now - elapsed;
    }

    // Null while the gateway's own clock is served: no plant clock is selected, or its estimate does not exist yet.
    ClockModel? Known => _plant.Control?.Model is { IsKnown: true } model ? model : null;

    /// <summary>State of C1. The gateway's own clock counts as converging while it is not synchronised with its reference.</summary>
    public ClockState State => _plant.Control?.Model.State ?? (_own.IsSynchronised ? ClockState.Synchronised : ClockState.Converging);

    /// <summary>Converts a time of a plant's clock to C1.</summary>
    /// <param name="from">The plant's clock; null for a time that is already on C1.</param>
    /// <returns>
    /// False while either clock is unknown, if the plant's clock is no longer accurate enough, or if the time is far from the current time of that
    /// clock.
    /// </returns>
    public bool TryMap(PlantClock from, ControlTime time, out ControlTime onControl)
    {
        onControl = time;
        if (from == null) return true;
        var model = from.Model;
        if (from == _plant.Control) return model.IsKnown;
        var now = _plant.Counter.Now;
        if (!ClockSettings.Default.Trusts(model) || OffsetToControl(model, now) is not { } ahead || !IsNear(time, model.ToControl(now))) return false;
        // Uses the current offset. A stamp is at most a second old, and two clocks diverge by only microseconds in a second.
        onControl = time - ahead;
        return true;
    }

    /// <summary>Gets the error bound on C1 of the times of a plant's clock that <see cref="TryMap"/> has converted.</summary>
    public TimeSpan ErrorBoundOf(PlantClock clock) => clock == _plant.Control ? ErrorBound : ErrorBound + clock.Model.ErrorBound;

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
            clock.RoundTripTime, model.IsKnown ? model.EstimatedError : null, model.ErrorBound, clock.Resolution, clock.Exchanges, clock.Failures, clock.LastFailure,
            clock.WrongRate);
    }

    TimeSpan? OffsetToControl(in ClockModel model, HeadsetTime now)
    {
        if (!model.IsKnown || _plant.Control?.Model.IsKnown == false) return null;
        var control = _plant.Control is { } plant ? plant.Model.ToControl(now) : _own.Now;
        return model.ToControl(now) - control;
    }

    // A stamp that differs by a century is not from this clock, and converting it could overflow the time types.
    static bool IsNear(ControlTime stamp, ControlTime now) =>
        Math.Abs((decimal)stamp.SinceEpoch.Ticks - now.SinceEpoch.Ticks) < (decimal)TimeSpan.TicksPerDay * 36500;
}
