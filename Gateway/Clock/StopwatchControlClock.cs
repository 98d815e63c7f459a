using System.Diagnostics;

namespace Nowpose.Gateway.Clock;

/// <summary>A control clock based on this machine's monotonic counter, with its own epoch and rate.</summary>
/// <remarks>Serves as the ground truth of a simulation: <see cref="AtCount"/> gives its time at any count of <see cref="Stopwatch"/>.</remarks>
/// <param name="atStart">Time that the clock shows now.</param>
/// <param name="skew">Rate minus one: the clock advances (1 + skew) seconds per second of the counter. 1e-6 is 1 ppm.</param>
public sealed class StopwatchControlClock(ControlTime atStart, double skew = 0) : IControlClock
{
    readonly long _startCount = Stopwatch.GetTimestamp();

    public ControlTime Now => AtCount(Stopwatch.GetTimestamp());

    public double Skew => skew;

    public TimeSpan ErrorBound { get; init; }
    public bool IsSynchronised { get; init; } = true;

    /// <summary>
    /// Step to which times are rounded down: by default the 100 ns of the time types; longer for a controller that stamps whole cycles.
    /// </summary>
    public TimeSpan Resolution { get; init; } = new(1);

    /// <summary>Creates a clock that shows Unix time from now on.</summary>
    public static StopwatchControlClock FromUnixTime(double skew = 0) => new(new ControlTime(DateTime.UtcNow - DateTime.UnixEpoch), skew);

    /// <summary>Gets the clock's time when <see cref="Stopwatch.GetTimestamp"/> returns <paramref name="count"/>.</summary>
    public ControlTime AtCount(long count)
    {
        // Computes whole ticks in integers. The part due to skew is small, so a double holds it with a resolution far below a tick.
        var elapsed = (long)((Int128)(count - _startCount) * TimeSpan.TicksPerSecond / Stopwatch.Frequency);
        var shown = atStart + new TimeSpan(elapsed + (long)Math.Round(elapsed * skew));
        return shown - new TimeSpan(FloorRest(shown.SinceEpoch.Ticks, Resolution.Ticks));
    }

    /// <summary>Gets the clock as a linear function of this machine's monotonic counter: C1 = intercept + rate · counter, all in ns.</summary>
    /// <remarks>
    /// On Linux the counter is CLOCK_MONOTONIC, which all processes of a machine share. The function does not round to the resolution.
    /// </remarks>
    public (long InterceptNs, double Rate) OverMonotonicCounter
    {
        get
        {
            var startNs = (long)((Int128)_startCount * 1_000_000_000 / Stopwatch.Frequency);
            return (atStart.Nanoseconds - startNs - (long)Math.Round(startNs * skew), 1 + skew);
        }
    }

    static long FloorRest(long ticks, long step) => step <= 1 ? 0 : (ticks % step + step) % step;
}
