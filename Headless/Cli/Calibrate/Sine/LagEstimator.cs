namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>The lag of one signal behind another by cross-correlation, finer than the interval of their instants.</summary>
/// <remarks>
/// Pearson's correlation of shown(t) with robot(t − lag) at lags of whole instants, so that noise weighs on each alike; the peak is
/// that of a parabola through the values around the greatest. The same instants of the hologram are compared at every lag: so
/// the peak is where a straight line through (robot, shown) leaves least, and periods that are cut off at the ends do not move it.
/// </remarks>
static class LagEstimator
{
    const double LeastLag = -0.1, GreatestLag = 0.6;

    /// <summary>Below, what is seen is not what the robot did.</summary>
    const double LeastCorrelation = 0.9;

    /// <summary>Another peak as high as this share of the greatest makes it ambiguous.</summary>
    const double Ambiguous = 0.98;

    /// <summary>The parabola goes through lags at which the correlation has lost no more than this.</summary>
    const double Crown = 0.06;
    const int LeastCrown = 2;

    /// <summary>Instants to either side between which the speed is taken: fewer, and a camera's noise would look like motion.</summary>
    const int SpeedSpan = 5;

    /// <exception cref="InputException">Nothing moves, the two do not move alike, or the motion repeats within the lags that are tried.</exception>
    public static LagEstimate Of(SineTracks tracks)
    {
        var first = (int)Math.Ceiling(LeastLag / tracks.Interval);
        var last = (int)Math.Floor(GreatestLag / tracks.Interval);
        RequireMotion(tracks.Robot, "the robot");
        RequireMotion(tracks.Shown, "the hologram");
        if (tracks.Shown.Length < 3 * last) throw new InputException(FormattableString.Invariant(
            $"recording: {tracks.Shown.Length * tracks.Interval:0.0} s are too short to look for lags up to {GreatestLag} s; record ten seconds"));
        var correlations = Enumerable.Range(first, last - first + 1).Select(lag => Fit.Of(tracks, lag, Math.Max(0, last), tracks.Shown.Length + Math.Min(0, first)).Correlation).ToArray();
        var peak = Array.IndexOf(correlations, correlations.Max());
        Check(correlations, peak, first, tracks.Interval);
        var half = HalfCrown(correlations, peak);
        var lag = Peak(correlations, peak, half);
        return new LagEstimate(
            (first + lag) * tracks.Interval, Deviation(tracks, first, last, first + peak), correlations[peak],
            [.. Enumerable.Range(first, correlations.Length).Select(each => each * tracks.Interval)], correlations);
    }

    static void RequireMotion(double[] positions, string what)
    {
        if (positions.Max() - positions.Min() > 0) return;
        throw new InputException($"recording: {what} does not move; jog a joint to and fro while it is filmed");
    }

    static void Check(double[] correlations, int peak, int first, double interval)
    {
        if (correlations[peak] < LeastCorrelation)
            throw new InputException(FormattableString.Invariant(
                $"recording: the hologram does not follow the robot: correlation {correlations[peak]:0.00}, at least {LeastCorrelation} is needed; ")
                + "check the columns, and whether one of them counts backwards (--inverted)");
        if (peak == 0 || peak == correlations.Length - 1)
            throw new InputException(FormattableString.Invariant(
                $"recording: the best lag lies at or beyond {(first + peak) * interval * 1000:0} ms; allowed are {LeastLag * 1000:0} to {GreatestLag * 1000:0} ms; check both clocks"));
        for (var i = 1; i < correlations.Length - 1; i++)
        {
            var isPeak = correlations[i] >= correlations[i - 1] && correlations[i] >= correlations[i + 1];
            if (!isPeak || Valley(correlations, i, peak) > Ambiguous * correlations[i] || correlations[i] < Ambiguous * correlations[peak] || i == peak) continue;
            throw new InputException(FormattableString.Invariant(
                $"recording: the motion repeats after {Math.Abs(peak - i) * interval:0.00} s, so the lag is ambiguous; jog slower, a period of 2 s or more"));
        }
    }

    static double Valley(double[] correlations, int a, int b) => correlations[Math.Min(a, b)..(Math.Max(a, b) + 1)].Min();

    static int HalfCrown(double[] correlations, int peak)
    {
        var half = LeastCrown;
        while (peak - half > 0 && peak + half < correlations.Length - 1
            && correlations[peak - half] > correlations[peak] - Crown && correlations[peak + half] > correlations[peak] - Crown) half++;
        return Math.Min(half, Math.Min(peak, correlations.Length - 1 - peak));
    }

    // Least squares of a parabola about the greatest value: its odd and even parts are independent on a symmetric grid.
    static double Peak(double[] correlations, int peak, int half)
    {
        double s0 = 0, s2 = 0, s4 = 0, y0 = 0, y1 = 0, y2 = 0;
        for (var d = -half; d <= half; d++)
        {
            double y = correlations[peak + d], square = d * d;
            s0++;
            s2 += square;
            s4 += square * square;
            y0 += y;
            y1 += d * y;
            y2 += square * y;
        }
        var curvature = (s0 * y2 - s2 * y0) / (s0 * s4 - s2 * s2);
        return curvature < 0 ? peak - Math.Clamp(y1 / s2 / (2 * curvature), -half, half) : peak;
    }

    /// <summary>Of a shift by least squares: what the line leaves over the speed with which shifting changes it; s.</summary>
    static double Deviation(SineTracks tracks, int first, int last, int lag)
    {
        int from = Math.Max(0, last), to = tracks.Shown.Length + Math.Min(0, first);
        var fit = Fit.Of(tracks, lag, from, to);
        double motion = 0;
        for (var i = from; i < to; i++)
        {
            int before = Math.Max(0, i - lag - SpeedSpan), after = Math.Min(tracks.Robot.Length - 1, i - lag + SpeedSpan);
            var speed = fit.Slope * (tracks.Robot[after] - tracks.Robot[before]) / ((after - before) * tracks.Interval);
            motion += speed * speed;
        }
        return Math.Sqrt(fit.Left / (to - from - 2) / motion);
    }

    /// <summary>The straight line that makes the hologram's place of the robot's, so many instants before.</summary>
    /// <param name="Left">Sum of the squares that it leaves.</param>
    readonly record struct Fit(double Correlation, double Slope, double Left)
    {
        public static Fit Of(SineTracks tracks, int lag, int from, int to)
        {
            double meanRobot = 0, meanShown = 0;
            for (var i = from; i < to; i++)
            {
                meanRobot += tracks.Robot[i - lag];
                meanShown += tracks.Shown[i];
            }
            meanRobot /= to - from;
            meanShown /= to - from;
            double both = 0, robot = 0, shown = 0;
            for (var i = from; i < to; i++)
            {
                double r = tracks.Robot[i - lag] - meanRobot, s = tracks.Shown[i] - meanShown;
                both += r * s;
                robot += r * r;
                shown += s * s;
            }
            return robot > 0 && shown > 0 ? new(both / Math.Sqrt(robot * shown), both / robot, shown - both * both / robot) : default;
        }
    }
}
