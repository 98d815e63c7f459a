using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Display;

/// <summary>The criteria by which L_visu scatters beyond the constant-latency range.</summary>
static class SpreadCriteria
{
    /// <summary>Minimum ratio of the standard deviations, beyond to inside.</summary>
    const double Factor = 3;

    /// <summary>Minimum range beyond, as a share of the refresh interval.</summary>
    const double RefreshShare = 0.75;

    /// <param name="where">Where L_visu scatters, at the beginning of a sentence, for example "At 1 500 000 vertices,".</param>
    /// <param name="inside">L_visu of all pictures inside the range, ms.</param>
    /// <param name="beyond">The groups beyond the range; none if there is none.</param>
    public static IEnumerable<Criterion> Of(string where, IEnumerable<double> inside, IReadOnlyCollection<SpreadGroup> beyond)
    {
        var within = Spread.Of(inside);
        (string Name, Spread Spread)[] spreads = [.. beyond.Select(group => (group.Name, Spread.Of(group.VisuMs)))];
        yield return Each(
            $"{where} the standard deviation of L_visu is at least {Factor} times that within the range, each of the middle 95 %.",
            [.. spreads.Select(each => (each.Name, each.Spread.Deviation))], Factor * within.Deviation, $"within the range {Text(within.Deviation)} ms");
        yield return Each(
            $"{where} the middle 95 % of L_visu extend over at least {Percent(RefreshShare)} of a refresh interval, {Text(DisplayConditions.RefreshMs)} ms.",
            [.. spreads.Select(each => (each.Name, each.Spread.Range))], RefreshShare * DisplayConditions.RefreshMs,
            $"within the range {Text(within.Range)} ms");
    }

    static Criterion Each(string statement, (string Name, double Ms)[] groups, double minMs, string within)
    {
        if (groups.Length == 0 || minMs == 0) return new(statement, false, groups.Length == 0 ? "no picture beyond the range" : "no scatter within the range");
        var missed = groups.Where(group => group.Ms < minMs).ToArray();
        var (min, max) = (Text(groups.Min(group => group.Ms)), Text(groups.Max(group => group.Ms)));
        var measured = $"{min}{(groups.Length == 1 ? "" : $" to {max}")} ms; {within}";
        return new(statement, missed.Length == 0, missed.Length == 0 || groups.Length == 1 ? measured
            : $"{measured}; less at {string.Join(", ", missed.Select(group => $"{group.Name} ({Text(group.Ms)} ms)"))}");
    }
}
