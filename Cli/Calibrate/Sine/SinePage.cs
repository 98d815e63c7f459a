using System.Globalization;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Creates the page that reports a back-and-forth jog: both motions, and their correlation as a function of the lag.</summary>
static class SinePage
{
    static readonly FigureColumn Time = new("time", "s"), Place = new("place, scaled"), Lag = new("lag", "ms"), Correlation = new("correlation");

    /// <param name="profile">The profile; null if L_visu was not requested.</param>
    public static CalibrationPageData Of(SineResult result, LatencyProfile profile, string path) => new(SinePageTexts.Title, Sentence(result),
        [
            ["Total latency", Ms(result.TotalMs)], ["Standard error", Ms(result.DeviationMs)], .. profile == null ? [] : ProfileFacts.Of(profile),
            [SinePageTexts.PeriodLabel, SinePageTexts.Period(result.PeriodSeconds)],
            ["Correlation", result.Lag.Correlation.ToString("0.0000", CultureInfo.InvariantCulture)],
            ["Pictures", result.Tracks.Shown.Length.ToString(CultureInfo.InvariantCulture)],
            ["Camera", (1 / result.Tracks.Interval).ToString("0.##", CultureInfo.InvariantCulture) + " per second"],
            ["Evaluated as", result.Way.Explanation], ["Recording", path],
        ])
    {
        Warnings = [.. WarningsOf(result, profile)],
        Sections = [Motions(result), Correlations(result)],
    };

    static IEnumerable<string> WarningsOf(SineResult result, LatencyProfile profile)
    {
        const double CertainMs = 1.5, MaxFlashMs = 3;
        if (profile == null) yield return SineMessages.NoProfile;
        if (result.FlashMs > MaxFlashMs)
            yield return SineMessages.SteadyFlashes(1 / result.Tracks.Interval, result.FlashMs);
        if (result.StepsMs > CertainMs)
            yield return SineMessages.SteppedGhost(result.Way.HeldMs, result.StepsMs);
        else if (1000 * result.Lag.Deviation > CertainMs)
            yield return SineMessages.StandardError(1000 * result.Lag.Deviation);
    }

    static string Sentence(SineResult result) => result.VisuMs is double visu
        ? SinePageTexts.VisuResult(visu, result.DeviationMs, result.TotalMs)
        : SinePageTexts.LagResult(result.TotalMs, result.DeviationMs);

    static CalibrationSection Motions(SineResult result)
    {
        double[] time = [.. Enumerable.Range(0, result.Tracks.Shown.Length).Select(i => i * result.Tracks.Interval)];
        PlotTrace Trace(string label, string look, double[] at, double[] places) => new(label, look, at, Scaled(places));
        return new("Robot and hologram", null, SinePageTexts.MotionsNote,
            [new("Over time", Time, Place,
            [
                Trace("robot", Looks.Truth, time, result.Tracks.Robot),
                Trace("hologram", Looks.Hold, time, result.Tracks.Shown),
                Trace(SinePageTexts.ShiftedHologram, Looks.Adaptive, [.. time.Select(t => t - result.Lag.LagSeconds)], result.Tracks.Shown),
            ])]);
    }

    static CalibrationSection Correlations(SineResult result) => new(SinePageTexts.Correlation, null, SinePageTexts.CorrelationNote,
        [new("Over the lag", Lag, Correlation, [new("correlation", Looks.Adaptive,
            [.. result.Lag.Lags.Select(each => 1000 * each)], [.. result.Lag.Correlations.Select(each => (double?)each)])])
        {
            Marks = [new(FormattableString.Invariant($"{1000 * result.Lag.LagSeconds:0.0} ms"), 1000 * result.Lag.LagSeconds)],
        }]);

    static double?[] Scaled(double[] places)
    {
        double min = places.Min(), range = places.Max() - min;
        return [.. places.Select(each => (double?)(2 * (each - min) / range - 1))];
    }

    static string Ms(double value) => value.ToString("0.00", CultureInfo.InvariantCulture) + " ms";
}
