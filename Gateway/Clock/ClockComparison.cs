namespace Nowpose.Gateway.Clock;

/// <summary>Logs the offset and skew of each clock of the control system relative to C1: once, and again when the offset has changed.</summary>
sealed class ClockComparison : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    /// <summary>Minimum change of the offset that is logged, in addition to the error bounds of both measurements.</summary>
    static readonly TimeSpan MinChange = TimeSpan.FromMilliseconds(1);

    readonly ServedClock _served;
    readonly Action<string> _log;
    readonly PeriodicTask _look;
    readonly Dictionary<string, (TimeSpan Ahead, TimeSpan Bound)> _logged = [];
    readonly Dictionary<string, (ClockState State, long Exchanges)> _states = [];

    public ClockComparison(ServedClock served, Action<string> log)
    {
        (_served, _log) = (served, log);
        _look = new PeriodicTask(LookNow, Interval, PlantClockMessages.NotCompared, log, TimeProvider.System);
    }

    public void Start() => _look.Start();

    public void Dispose() => _look.Dispose();

    /// <summary>Compares once, unless the previous comparison is still running.</summary>
    internal void Look() => _look.RunUnlessBusy();

    void LookNow()
    {
        var clocks = _served.Status();
        _served.Stamps.Look(_log);
        foreach (var clock in clocks) LookAt(clock, clocks.FirstOrDefault(other => other.IsControlClock));
    }

    void LookAt(PlantClockStatus clock, PlantClockStatus control)
    {
        var before = _states.GetValueOrDefault(clock.Name);
        _states[clock.Name] = (clock.State, clock.Exchanges);
        if (before.State != clock.State)
        {
            var why = clock.LastFailure == null || clock.Exchanges > before.Exchanges ? "" : $" ({clock.LastFailure})";
            _log(PlantClockMessages.State(clock.Name, clock.State.Word() + why, clock.IsControlClock));
        }

        if (clock.IsControlClock || clock.OffsetToControl is not { } ahead || clock.State != ClockState.Synchronised) return;
        var bound = clock.ErrorBound + (control?.ErrorBound ?? TimeSpan.Zero);
        if (_logged.TryGetValue(clock.Name, out var logged) && (ahead - logged.Ahead).Duration() <= logged.Bound + bound + MinChange) return;
        _logged[clock.Name] = (ahead, bound);
        _log(PlantClockMessages.Compared(clock.Name, ahead.TotalMilliseconds, bound.TotalMilliseconds, _served.Source, clock.SkewPpm));
    }
}
