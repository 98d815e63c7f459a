using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>
/// The resolution of the control clock that a log does not tell: a PLC stamps the beginning of its cycle, so all its stamps
/// are whole cycles apart, and half a cycle late on average.
/// </summary>
static class LoggedResolution
{
    /// <summary>Fewer stamps may be whole milliseconds apart by chance.</summary>
    const int FewestExchanges = 50;

    /// <summary>Below, half of it hardly matters; above, no control system is that slow.</summary>
    const long LeastNs = 100_000, GreatestNs = 20_000_000;

    /// <summary>A log of made-up times may be round on both clocks: then the control clock's are none of its cycle.</summary>
    const int FinerHeadsetClock = 10;

    /// <param name="rows">t1, t2, t3, t4 in ns.</param>
    /// <returns>Zero where the stamps do not show one.</returns>
    public static TimeSpan Of(IReadOnlyList<long[]> rows)
    {
        if (rows.Count < FewestExchanges) return TimeSpan.Zero;
        var control = CommonStep(rows, 1, 2);
        if (control is < LeastNs or > GreatestNs || CommonStep(rows, 0, 3) > control / FinerHeadsetClock) return TimeSpan.Zero;
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
