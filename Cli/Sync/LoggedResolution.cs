using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>
/// Determines the resolution of the control clock from the time stamps of a log, row by row. The time stamps of a PLC are the start times of its
/// cycles. Their differences are multiples of the cycle time, and the stamps are half a cycle early on average.
/// </summary>
sealed class LoggedResolution
{
    /// <summary>
    /// Minimum number of exchanges. With fewer, stamps can differ by whole milliseconds by chance. The clock is not synchronised before, so no
    /// synchronised estimate lacks the resolution.
    /// </summary>
    static readonly int MinExchanges = ClockSettings.Default.ExchangesToSynchronise;

    /// <summary>Range of the resolution, ns. Half of a shorter cycle is negligible; a longer common step does not count as a cycle.</summary>
    const long MinNs = 100_000, MaxNs = 20_000_000;

    /// <summary>
    /// Minimum ratio of the control clock's resolution to the headset clock's. In a synthetic log, both clocks may be rounded to the same
    /// unit although the control system has no cycle.
    /// </summary>
    const int FinerHeadsetClock = 10;

    LoggedStamps _first;
    Int128 _control, _headset;
    int _rows;

    /// <summary>Adds the next row of the log.</summary>
    /// <returns>The resolution according to all rows so far; zero if they do not show one. It changes a few times at most.</returns>
    public TimeSpan Add(LoggedStamps row)
    {
        if (_rows++ == 0) _first = row;
        _control = CommonStep(_control, row.T2 - (Int128)_first.T2, row.T3 - (Int128)_first.T2);
        _headset = CommonStep(_headset, row.T1 - (Int128)_first.T1, row.T4 - (Int128)_first.T1);
        if (_rows < MinExchanges || _control < MinNs || _control > MaxNs || _headset > _control / FinerHeadsetClock) return TimeSpan.Zero;
        return TimeSpan.FromTicks((long)_control / TimeSpan.NanosecondsPerTick);
    }

    /// <summary>Returns the exchanges with the resolution that the complete log shows.</summary>
    public static IReadOnlyList<SyncExchange> ExchangesOf(IReadOnlyList<LoggedExchange> log)
    {
        var (logged, resolution) = (new LoggedResolution(), TimeSpan.Zero);
        foreach (var each in log)
            if (each.Stamps is { } stamps) resolution = logged.Add(stamps);
        return [.. log.Select(each => each.ExchangeWith(resolution))];
    }

    static Int128 CommonStep(Int128 step, Int128 first, Int128 second) =>
        GreatestCommonDivisor(GreatestCommonDivisor(step, Int128.Abs(first)), Int128.Abs(second));

    static Int128 GreatestCommonDivisor(Int128 a, Int128 b)
    {
        while (b != 0) (a, b) = (b, a % b);
        return a;
    }
}
