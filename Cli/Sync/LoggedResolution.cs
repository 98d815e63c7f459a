using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>
/// Determines the resolution of the control clock from the time stamps of a log. The time stamps of a PLC are the start times of its cycles.
/// Their differences are multiples of the cycle time, and the stamps are half a cycle early on average.
/// </summary>
static class LoggedResolution
{
    /// <summary>Minimum number of exchanges. With fewer, stamps can differ by whole milliseconds by chance.</summary>
    const int MinExchanges = 50;

    /// <summary>Range of the resolution, ns. Half of a shorter cycle is negligible; a longer common step does not count as a cycle.</summary>
    const long MinNs = 100_000, MaxNs = 20_000_000;

    /// <summary>
    /// Minimum ratio of the control clock's resolution to the headset clock's. In a synthetic log, both clocks may be rounded to the same
    /// unit although the control system has no cycle.
    /// </summary>
    const int FinerHeadsetClock = 10;

    /// <param name="rows">Rows of t1, t2, t3 and t4, ns.</param>
    /// <returns>The resolution; zero if the stamps do not show one.</returns>
    public static TimeSpan Of(IReadOnlyList<long[]> rows)
    {
        if (rows.Count < MinExchanges) return TimeSpan.Zero;
        var control = CommonStep(rows, 1, 2);
        if (control is < MinNs or > MaxNs || CommonStep(rows, 0, 3) > control / FinerHeadsetClock) return TimeSpan.Zero;
        return TimeSpan.FromTicks(control / TimeSpan.NanosecondsPerTick);
    }

    static long CommonStep(IReadOnlyList<long[]> rows, int first, int second)
    {
        Int128 step = 0;
        foreach (var row in rows)
            foreach (var column in (ReadOnlySpan<int>)[first, second])
                step = GreatestCommonDivisor(step, Int128.Abs((Int128)row[column] - rows[0][first]));
        return (long)Int128.Min(step, long.MaxValue);
    }

    static Int128 GreatestCommonDivisor(Int128 a, Int128 b)
    {
        while (b != 0) (a, b) = (b, a % b);
        return a;
    }
}
