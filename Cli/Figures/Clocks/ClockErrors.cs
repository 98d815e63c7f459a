namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Errors of one estimator over all runs. The errors of the offset are absolute errors from <see cref="SettledAfter"/> on.</summary>
/// <param name="SkewPpmEarly">RMS error of the skew from 2 to 10 s, ppm.</param>
/// <param name="SkewPpmLate">RMS error of the skew over the last quarter, ppm.</param>
sealed record ClockErrors(double P50Us, double P95Us, double MaximumUs, double SkewPpmEarly, double SkewPpmLate)
{
    /// <summary>Time after which the estimator has settled, s.</summary>
    public const double SettledAfter = 10;

    /// <summary>Time before which the error of the skew is not evaluated, s. By then, the estimator has made its first estimates.</summary>
    public const double FirstSkew = 2;

    /// <param name="runs">The estimates of each run, with the exchanges from which they were computed.</param>
    public static ClockErrors Of(IReadOnlyList<(ClockInstant[] Instants, SimulatedExchanges Log)> runs)
    {
        var settled = runs.SelectMany(r => r.Instants).Where(i => i.Seconds >= SettledAfter)
            .Select(i => Math.Abs(i.OffsetErrorUs ?? double.PositiveInfinity)).Order().ToArray();
        double Skew(double from, double to)
        {
            var squares = runs.SelectMany(r => r.Instants.Where(i => i.Seconds >= from && i.Seconds < to && i.SkewPpm != null)
                .Select(i => Math.Pow(i.SkewPpm.Value - r.Log.SkewPpmAt(i.Seconds), 2))).ToArray();
            return Math.Sqrt(squares.Average());
        }
        var end = runs[0].Instants[^1].Seconds;
        return new ClockErrors(Quantile.Of(settled, 0.5), Quantile.Of(settled, 0.95), settled[^1], Skew(FirstSkew, SettledAfter), Skew(0.75 * end, end));
    }
}
