using System.Globalization;
using Nowpose.Cli;

namespace Nowpose.Benchmarks.Links;

/// <summary>
/// Accuracy limits for each link. They apply to the medians over the repeats unless stated otherwise. The limit for the share within the
/// stated error applies to all runs together.
/// </summary>
static class LinkLimits
{
    /// <summary>Minimum duration of a run to which the limits apply, s. The reduction of the error increases with the duration.</summary>
    public const double Seconds = 30;

    const double CurrentAfterS = 2, CurrentAfterAtWorstS = 3;
    const double WithinStatedShare = 0.99;
    const double CurrentShare = 0.95;
    const double HeldAfterS = 0.3, RecoveredAfterS = 0.5;

    static readonly Dictionary<string, double> Reduction = new()
    {
        ["clean"] = 0.94, ["wifi"] = 0.94, ["lossy"] = 0.92, ["cellular"] = 0.92, ["bad"] = 0.8,
    };

    /// <param name="runs">All runs of one profile.</param>
    /// <returns>One line for each limit that was not met.</returns>
    public static IEnumerable<string> Missed(IReadOnlyList<LinkResult> runs)
    {
        var profile = runs[0].Profile;
        var stalls = LinkProfile.Named(profile).StallInterval > TimeSpan.Zero;
        string AtMost(string what, double? value, double limit, string unit) =>
            value <= limit ? null : $"{profile}: {what}: {Text(value, unit)}; the limit is {Text(limit, unit)}";
        string AtLeast(string what, double? value, double limit) =>
            value >= limit ? null : $"{profile}: {what}: {Text(100 * value, "%")}; at least {Text(100 * limit, "%")} are required";
        var missed = new List<string>
        {
            AtLeast("share of frames with a clock error within the stated error", runs.Average(run => run.WithinStatedShare), WithinStatedShare),
        };
        if (stalls)
        {
            missed.Add(AtMost("time until the pose is shown as held", Median(runs, run => run.HeldAfterS), HeldAfterS, "s"));
            missed.Add(AtMost("time until the pose is current again", Median(runs, run => run.RecoveredAfterS), RecoveredAfterS, "s"));
        }
        else
        {
            missed.Add(AtMost("time until the pose is current", Median(runs, run => run.CurrentAfterS), CurrentAfterS, "s"));
            missed.Add(AtMost(
                "time until the pose is current in the worst run",
                runs.Max(run => run.CurrentAfterS ?? double.PositiveInfinity), CurrentAfterAtWorstS, "s"));
            missed.Add(AtLeast("share of current frames", Median(runs, run => run.CurrentShare), CurrentShare));
            missed.Add(AtLeast("reduction", Median(runs, run => run.Reduction), Reduction[profile]));
        }

        return missed.Where(line => line != null);
    }

    /// <summary>Gets the median over the runs that have a value; null if at least half of the runs have none.</summary>
    public static double? Median(IReadOnlyList<LinkResult> runs, Func<LinkResult, double?> value)
    {
        var known = runs.Select(value).Where(v => v.HasValue).Select(v => v.Value).ToList();
        return 2 * known.Count <= runs.Count ? null : Quantile.Of(known, 0.5);
    }

    static string Text(double? value, string unit) =>
        value is double number && double.IsFinite(number) ? string.Create(CultureInfo.InvariantCulture, $"{number:0.###} {unit}") : "none";
}
