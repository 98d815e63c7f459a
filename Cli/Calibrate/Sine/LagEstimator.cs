namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Estimates the lag of one signal behind another by cross-correlation, more precisely than their sampling interval.</summary>
/// <remarks>
/// Pearson's correlation of shown(t) and robot(t − lag) is computed at lags of whole sampling intervals. Near its maximum, the model is
/// shown = a + b·robot − b·δ·robot′, and least squares give the remaining shift δ. The speed robot′ is a difference over several
/// intervals, which reduces the effect of the camera's noise, but also the speed itself. The fit is therefore repeated at the lag found,
/// with robot positions interpolated between instants, until δ is 0. Every lag is evaluated at the same instants of the hologram, so
/// incomplete periods at the ends do not bias the result.
/// </remarks>
static class LagEstimator
{
    const double MinLag = -0.1, MaxLag = 0.6;

    /// <summary>Minimum correlation. Below it, the hologram does not follow the robot.</summary>
    const double MinCorrelation = 0.9;

    /// <summary>Minimum height of a second maximum, relative to the first one, that makes the result ambiguous.</summary>
    const double Ambiguous = 0.98;

    /// <summary>
    /// The speed at an instant is computed from the positions this time before and after it, s. With a shorter time, the noise of the camera
    /// would look like motion.
    /// </summary>
    const double SpeedSpan = 1 / 12.0;

    /// <summary>The fit is repeated until the remaining shift is smaller, in instants.</summary>
    const double Tolerance = 1e-3;

    /// <summary>Maximum number of fits. A slow jog needs three or four.</summary>
    const int MaxFits = 10;

    /// <exception cref="InputException">
    /// The interval exceeds the tested lags, nothing moves, the two motions differ, or the motion repeats within the tested lags.
    /// </exception>
    public static LagEstimate Of(SineTracks tracks)
    {
        if (tracks.Interval > MaxLag) throw new InputException(SineMessages.IntervalTooLong(tracks.Interval, MaxLag));
        var first = (int)Math.Ceiling(MinLag / tracks.Interval);
        var last = (int)Math.Floor(MaxLag / tracks.Interval);
        RequireMotion(tracks.Robot, "the robot");
        RequireMotion(tracks.Shown, "the hologram");
        if (tracks.Shown.Length < 3 * last) throw new InputException(SineMessages.TooShort(tracks.Shown.Length * tracks.Interval, MaxLag));
        int from = Math.Max(0, last), to = tracks.Shown.Length + Math.Min(0, first);
        var correlations = Enumerable.Range(first, last - first + 1).Select(lag => ShiftFit.Of(tracks, null, lag, from, to).Correlation).ToArray();
        var peak = Array.IndexOf(correlations, correlations.Max());
        Check(correlations, peak, first, tracks.Interval);
        var speeds = SpeedsOf(tracks.Robot, Math.Max(1, (int)Math.Round(SpeedSpan / tracks.Interval)));
        double instants = first + peak, shift = double.PositiveInfinity;
        for (var fits = 0; fits < MaxFits && Math.Abs(shift) > Tolerance; fits++)
        {
            shift = ShiftFit.Of(tracks, speeds, instants, from, to).Shift;
            instants = Math.Clamp(instants + shift, first, last);
        }
        // At a whole number of instants, because interpolation reduces the noise of the robot's track.
        var deviation = ShiftFit.Of(tracks, speeds, Math.Round(instants), from, to).Deviation;
        return new LagEstimate(
            instants * tracks.Interval, deviation * tracks.Interval, correlations[peak],
            [.. Enumerable.Range(first, correlations.Length).Select(each => each * tracks.Interval)], correlations);
    }

    static double[] SpeedsOf(double[] positions, int span)
    {
        double SpeedAt(int instant)
        {
            int before = Math.Max(0, instant - span), after = Math.Min(positions.Length - 1, instant + span);
            return (positions[after] - positions[before]) / (after - before);
        }
        return [.. Enumerable.Range(0, positions.Length).Select(SpeedAt)];
    }

    static void RequireMotion(double[] positions, string what)
    {
        if (positions.Max() - positions.Min() > 0) return;
        throw new InputException(SineMessages.NoMotion(what));
    }

    static void Check(double[] correlations, int peak, int first, double interval)
    {
        if (correlations[peak] < MinCorrelation)
            throw new InputException(SineMessages.NoCorrelation(correlations[peak], MinCorrelation));
        if (peak == 0 || peak == correlations.Length - 1)
            throw new InputException(SineMessages.LagOutOfRange((first + peak) * interval * 1000, MinLag * 1000, MaxLag * 1000));
        for (var i = 1; i < correlations.Length - 1; i++)
        {
            var isPeak = correlations[i] >= correlations[i - 1] && correlations[i] >= correlations[i + 1];
            if (!isPeak || Valley(correlations, i, peak) > Ambiguous * correlations[i] || correlations[i] < Ambiguous * correlations[peak] || i == peak) continue;
            throw new InputException(SineMessages.Ambiguous(Math.Abs(peak - i) * interval));
        }
    }

    static double Valley(double[] correlations, int a, int b) => correlations[Math.Min(a, b)..(Math.Max(a, b) + 1)].Min();
}

/// <summary>The lag of the hologram behind the robot.</summary>
/// <param name="LagSeconds">Lag with the maximum correlation, interpolated between instants, s.</param>
/// <param name="Deviation">Standard error of the lag caused by the camera's noise, s.</param>
/// <param name="Correlation">Maximum of the correlation, 0 to 1.</param>
/// <param name="Lags">The tested lags, s.</param>
/// <param name="Correlations">Correlation at each of the tested lags.</param>
sealed record LagEstimate(double LagSeconds, double Deviation, double Correlation, double[] Lags, double[] Correlations);
