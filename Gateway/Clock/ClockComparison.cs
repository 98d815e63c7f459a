using System.Globalization;

namespace Nowpose.Gateway.Clock;

/// <summary>Says in the log how the clocks of one control system differ: once, and again when the difference has moved.</summary>
sealed class ClockComparison(ServedClock served, Action<string> log) : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    /// <summary>More than this beyond what both bounds explain has moved.</summary>
    static readonly TimeSpan Moved = TimeSpan.FromMilliseconds(1);

    readonly Dictionary<string, (TimeSpan Ahead, TimeSpan Bound)> _said = [];
    readonly Dictionary<string, ClockState> _states = [];
    Timer _timer;

    public void Start() => _timer = new Timer(_ => Look(), null, Interval, Interval);

    public void Dispose() => _timer?.Dispose();

    /// <summary>Looks once; one thread at a time.</summary>
    internal void Look()
    {
        // A slow log must not let two looks meet.
        if (!Monitor.TryEnter(_said)) return;
        try
        {
            var clocks = served.Status();
            served.Stamps.Look(log);
            foreach (var clock in clocks) LookAt(clock, clocks.FirstOrDefault(other => other.IsControlClock));
        }
        catch (Exception e)
        {
            // All of them: an exception that leaves a timer's thread ends the process.
            log($"clock: the clocks could not be compared ({e.GetType().Name}: {e.Message})");
        }
        finally
        {
            Monitor.Exit(_said);
        }
    }

    void LookAt(PlantClockStatus clock, PlantClockStatus control)
    {
        if (_states.GetValueOrDefault(clock.Name) != clock.State)
        {
            _states[clock.Name] = clock.State;
            log($"clock '{clock.Name}': {clock.State.Word()}{Why(clock)}{(clock.IsControlClock ? "; it is the control clock" : "")}");
        }

        if (clock.IsControlClock || clock.OffsetToControl is not { } ahead || clock.State != ClockState.Synchronised) return;
        var bound = clock.ErrorBound + (control?.ErrorBound ?? TimeSpan.Zero);
        if (_said.TryGetValue(clock.Name, out var said) && (ahead - said.Ahead).Duration() <= said.Bound + bound + Moved) return;
        _said[clock.Name] = (ahead, bound);
        log(string.Create(CultureInfo.InvariantCulture,
            $"clock '{clock.Name}': {ahead.TotalMilliseconds:+0.00;-0.00;0.00} ms (± {bound.TotalMilliseconds:0.00}) ")
            + string.Create(CultureInfo.InvariantCulture, $"against '{served.Source}', drifting by {clock.DriftPpm:+0.0;-0.0;0.0} ppm"));
    }

    static string Why(PlantClockStatus clock) =>
        clock.State is ClockState.Synchronised || clock.LastFailure == null ? "" : $" ({clock.LastFailure})";
}
