namespace Nowpose.Unity.Tests.Demo.Paper;

/// <summary>
/// Computes Φ*, the round-trip time and ε_i from the written timestamps of the exchanges, independently of the product's code. ε_i is computed twice:
/// with the written γ₂ and Θ₂, and with a fit of its own, which uses RANSAC and a moving average with the numbers of Fig. 8. This fit tries the lines
/// through all pairs of exchanges, whereas the product tries 20 random ones. All lines in the average have equal weights, as in the paper.
/// </summary>
sealed class WrittenClock
{
    const int History = 100, Averaged = 20, MinForLine = 3;
    const double InlierMs = 1, NsPerMs = 1e6, NsPerSecond = 1e9;

    /// <param name="exchanges">The rows of the file. Headset times are relative to the first t1, control times to the first t2.</param>
    public WrittenClock(IReadOnlyList<IReadOnlyDictionary<string, double>> exchanges)
    {
        double[] absolute = [.. exchanges.Select(each => (each["t1_ns"] - each["t2_ns"] + each["t4_ns"] - each["t3_ns"]) / 2 / NsPerMs)];
        OffsetsMs = [.. absolute.Select(ms => ms - absolute[0])];
        RoundTripsMs = [.. exchanges.Select(each => (each["t4_ns"] - each["t1_ns"]) / NsPerMs)];
        FitErrorsMs = [.. exchanges.Zip(OffsetsMs, (each, ms) =>
            ms - each["theta2_ms"] - each["skew_ppm"] * 1e-6 * (each["t4_ns"] - exchanges[0]["t4_ns"]) / NsPerMs)];
        OwnFitErrorsMs = ErrorsOf([.. exchanges.Select(each => each["t4_ns"] / NsPerSecond)], OffsetsMs);
    }

    /// <summary>Φ* of each exchange relative to that of the first one.</summary>
    public double[] OffsetsMs { get; }

    /// <summary>Time from sending the request to receiving the reply, as the paper defines RTT.</summary>
    public double[] RoundTripsMs { get; }

    /// <summary>ε_i of each exchange with the written estimates: Φ* − (γ₂−1)·t − Θ₂.</summary>
    public double[] FitErrorsMs { get; }

    /// <summary>ε_i of each exchange with this class's own fit up to this exchange. NaN before the first line.</summary>
    public double[] OwnFitErrorsMs { get; }

    static double[] ErrorsOf(double[] seconds, double[] offsetsMs)
    {
        var lines = new List<(double AtZero, double Slope)>();
        return [.. seconds.Select((time, newest) =>
        {
            var first = Math.Max(0, newest + 1 - History);
            if (newest + 1 - first < MinForLine) return double.NaN;
            lines.Add(LineThrough(seconds[first..(newest + 1)], offsetsMs[first..(newest + 1)]));
            return offsetsMs[newest] - lines.TakeLast(Averaged).Average(line => line.AtZero + line.Slope * time);
        })];
    }

    /// <summary>
    /// Finds the line through two of the points that has the most points within the bound, and fits a line to those points by least squares.
    /// </summary>
    static (double AtZero, double Slope) LineThrough(double[] x, double[] y)
    {
        var (most, at, steepness) = (0, 0, 0.0);
        for (var a = 0; a < x.Length; a++)
            for (var b = a + 1; b < x.Length; b++)
            {
                var slope = (y[b] - y[a]) / (x[b] - x[a]);
                var count = 0;
                for (var i = 0; i < x.Length; i++)
                    if (Math.Abs(y[i] - y[a] - slope * (x[i] - x[a])) < InlierMs) count++;
                if (count > most) (most, at, steepness) = (count, a, slope);
            }
        int[] inliers = [.. Enumerable.Range(0, x.Length).Where(i => Math.Abs(y[i] - y[at] - steepness * (x[i] - x[at])) < InlierMs)];
        double meanX = inliers.Average(i => x[i]), meanY = inliers.Average(i => y[i]);
        var fitted = inliers.Sum(i => (x[i] - meanX) * (y[i] - meanY)) / inliers.Sum(i => (x[i] - meanX) * (x[i] - meanX));
        return (meanY - fitted * meanX, fitted);
    }
}
