using System.Globalization;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Creates the page of a jog back and forth: both motions, and the correlation over the lag.</summary>
static class SinePage
{
    static readonly FigureColumn Time = new("time", "s"), Place = new("place, scaled"), Lag = new("lag", "ms"), Correlation = new("correlation");

    /// <param name="profile">The profile, or null if L_visu was not requested.</param>
    public static CalibrationPageData Of(SineResult result, LatencyProfile profile, string path) => new(
        "Latency of a jog back and forth", Sentence(result),
        [
            ["Total latency", Ms(result.TotalMs)], ["Standard error", Ms(result.DeviationMs)], .. profile == null ? [] : ProfileFacts.Of(profile),
            ["Correlation", result.Lag.Correlation.ToString("0.0000", CultureInfo.InvariantCulture)],
            ["Pictures", result.Tracks.Shown.Length.ToString(CultureInfo.InvariantCulture)],
            ["Camera", (1 / result.Tracks.Interval).ToString("0.##", CultureInfo.InvariantCulture) + " per second"],
            ["Evaluated as", result.Way.Words], ["Recording", path],
        ])
    {
        Warnings = [.. WarningsOf(result, profile)],
        Sections = [Motions(result), Correlations(result)],
    };

    static IEnumerable<string> WarningsOf(SineResult result, LatencyProfile profile)
    {
        const double CertainMs = 1.5;
        if (profile == null) yield return "no profile was written: state which part of the lag is L_visu with --app-ms or --told-ms";
        if (result.StepsMs > CertainMs)
            yield return FormattableString.Invariant(
                $"the ghost moves every {result.Way.HeldMs:0.##} ms, synchronously with the pictures: the result may be wrong by up to {result.StepsMs:0.0} ms; ")
                + "film the gripper instead (--told-ms), or film at another frame rate";
        else if (result.DeviationMs > CertainMs)
            yield return FormattableString.Invariant($"the standard error is {result.DeviationMs:0.0} ms: jog farther or faster, or film longer, to get below ± 3 ms");
    }

    static string Sentence(SineResult result) => result.VisuMs is double visu
        ? string.Create(CultureInfo.InvariantCulture, $"L_visu is {visu:0.0} ms ± {result.DeviationMs:0.0} ms; the total lag is {result.TotalMs:0.0} ms.")
        : string.Create(CultureInfo.InvariantCulture, $"The hologram is {result.TotalMs:0.0} ms ± {result.DeviationMs:0.0} ms behind the robot.");

    public static CalibrationSection Motions(SineResult result)
    {
        double[] time = [.. Enumerable.Range(0, result.Tracks.Shown.Length).Select(i => i * result.Tracks.Interval)];
        PlotTrace Trace(string label, string look, double[] at, double[] places) => new(label, look, at, Scaled(places));
        return new("Robot and hologram", null, "Each curve is scaled to its own range. Shifted forward by the lag, the hologram's curve agrees with the robot's.",
            [new("Over time", Time, Place,
            [
                Trace("robot", Looks.Truth, time, result.Tracks.Robot),
                Trace("hologram", Looks.Hold, time, result.Tracks.Shown),
                Trace("hologram, shifted by the lag", Looks.Adaptive, [.. time.Select(t => t - result.Lag.LagSeconds)], result.Tracks.Shown),
            ])]);
    }

    public static CalibrationSection Correlations(SineResult result) => new(
        "Correlation over the lag", null, "The peak is at the total latency. Between the camera's pictures it is found by a least-squares fit of the robot's position and speed.",
        [new("Over the lag", Lag, Correlation, [new("correlation", Looks.Adaptive,
            [.. result.Lag.Lags.Select(each => 1000 * each)], [.. result.Lag.Correlations.Select(each => (double?)each)])])
        {
            Marks = [new(FormattableString.Invariant($"{result.TotalMs:0.0} ms"), result.TotalMs)],
        }]);

    static double?[] Scaled(double[] places)
    {
        double min = places.Min(), range = places.Max() - min;
        return [.. places.Select(each => (double?)(2 * (each - min) / range - 1))];
    }

    static string Ms(double value) => value.ToString("0.00", CultureInfo.InvariantCulture) + " ms";
}
