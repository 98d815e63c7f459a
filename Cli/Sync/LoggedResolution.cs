using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>
/// Finds the resolution of the control clock, which a log does not contain. A PLC stamps the beginning of its cycle, so its stamps are
/// whole cycles apart, and half a cycle early on average.
/// </summary>
static class LoggedResolution
{
    /// <summary>Minimum number of exchanges. Fewer stamps may be whole milliseconds apart by chance.</summary>
    const int MinExchanges = 50;

    /// <summary>Range of the resolution, ns. Below it, half a cycle is negligible; no control system has a longer cycle.</summary>
    const long MinNs = 100_000, MaxNs = 20_000_000;

    /// <summary>Minimum ratio to the headset clock's resolution. In a synthetic log, both clocks may be rounded, without any cycle.</summary>
    const int FinerHeadsetClock = 10;

    /// <param name="rows">t1, t2, t3, t4 in ns.</param>
    /// <returns>Zero if the stamps do not show a resolution.</returns>
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
