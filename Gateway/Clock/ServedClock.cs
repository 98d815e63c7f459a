using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>What the gateway serves as C1: the control system's clock where an adapter tells it, and else its own.</summary>
/// <remarks>
/// A clock of the control system that was never known is replaced by the gateway's own, and not synchronised. One that has been lost for
/// so long that its bound exceeds what a headset bears in a holdover is served on, marked as not synchronised. Its step in time is
/// continuous here, so the resolution is that of the time types: what is coarse in the plant's clock is in the bound.
/// </remarks>
public sealed class ServedClock : IControlClock
{
    readonly IControlClock _own;
    readonly PlantClocks _plant;

    /// <param name="system">Clock and counter of the system, for the comparison with stamps; null for those of this machine.</param>
    internal ServedClock(IControlClock own, PlantClocks plant, TimeProvider system = null)
    {
        _own = own;
        _plant = plant;
        var systemClock = new SystemControlClock(system);
        Stamps = new StampWatch(() => Now, () => ErrorBound, () => _plant.Control == null ? _own : null, () => systemClock.Now, system ?? TimeProvider.System);
    }

    /// <summary>Compares the stamps of sources with this clock.</summary>
    internal StampWatch Stamps { get; }

    /// <summary>The name of the plant's clock that is C1; <see cref="PlantClocks.Own"/> for the gateway's.</summary>
    public string Source => _plant.Control?.Name ?? PlantClocks.Own;

    public ControlTime Now => Known is { } model ? model.ToControl(_plant.Counter.Now) : _own.Now;
    public TimeSpan ErrorBound => Known?.ErrorBound ?? _own.ErrorBound;
    public bool IsSynchronised => _plant.Control is { } control ? ClockSettings.Default.Trusts(control.Model) : _own.IsSynchronised;
    public TimeSpan Resolution => Known == null ? _own.Resolution : new TimeSpan(1);
    public double Skew => -Known?.Skew ?? _own.Skew;

    // Null while the gateway's own is served: also as long as the one that is to be C1 is not known.
    ClockModel? Known => _plant.Control?.Model is { IsKnown: true } model ? model : null;

    /// <summary>How far C1 is known: of the gateway's own clock synchronised, or converging where it says it is not.</summary>
    public ClockState State => _plant.Control?.Model.State ?? (_own.IsSynchronised ? ClockState.Synchronised : ClockState.Converging);

    /// <summary>A time that a clock of the plant showed, on C1.</summary>
    /// <param name="from">Null for a time that is on C1 already.</param>
    /// <returns>False while either clock is unknown, or the one that is not C1 no longer trusted.</returns>
    public bool TryMap(PlantClock from, ControlTime time, out ControlTime onControl)
    {
        onControl = time;
        if (from == null) return true;
        var model = from.Model;
        if (from == _plant.Control) return model.IsKnown;
        var now = _plant.Counter.Now;
        if (!ClockSettings.Default.Trusts(model) || OffsetToControl(model, now) is not { } ahead || !IsNear(time, model.ToControl(now))) return false;
        // The difference now is that of then: stamps are a second old, in which two clocks part by microseconds.
        onControl = time - ahead;
        return true;
    }

    /// <summary>How all clocks of the plant do.</summary>
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

    // A stamp of another century minus an offset may exceed what the types bear; and is none of this clock's.
    static bool IsNear(ControlTime stamp, ControlTime now) =>
        Math.Abs((decimal)stamp.SinceEpoch.Ticks - now.SinceEpoch.Ticks) < (decimal)TimeSpan.TicksPerDay * 36500;
}
