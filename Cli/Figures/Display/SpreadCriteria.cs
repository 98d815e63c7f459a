using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Creates the criteria for the scatter of L_visu beyond the constant-latency range.</summary>
static class SpreadCriteria
{
    /// <summary>Minimum ratio of the standard deviation beyond the range to the standard deviation inside it.</summary>
    const double Factor = 3;

    /// <summary>Minimum spread beyond the range, as a share of the refresh interval.</summary>
    const double RefreshShare = 0.75;

    /// <param name="where">The place where L_visu scatters, as the beginning of a sentence, for example "At 1 500 000 vertices,".</param>
    /// <param name="inside">L_visu of all pictures inside the range, ms.</param>
    /// <param name="beyond">
    /// The groups beyond the range; can be empty. They are judged together, each relative to its mean, because a latency that is only larger
    /// beyond the range does not scatter. The result also names the groups that do not meet the criterion on their own.
    /// </param>
    public static IReadOnlyList<Criterion> Of(string where, IEnumerable<double> inside, IReadOnlyCollection<SpreadGroup> beyond)
    {
        var within = Spread.Of(inside);
        return
        [
            Judge(Figure11Texts.Deviation(where, Factor),
                beyond, within, spread => spread.Deviation, Factor * within.Deviation),
            Judge(Figure11Texts.Spread(where, Percent(RefreshShare), Text(StudiedDisplay.RefreshMs)), beyond, within, spread => spread.Range, RefreshShare * StudiedDisplay.RefreshMs),
        ];
    }

    static Criterion Judge(string statement, IReadOnlyCollection<SpreadGroup> beyond, Spread within, Func<Spread, double> measure, double minMs)
    {
        if (beyond.Count == 0 || minMs == 0) return new(statement, false, beyond.Count == 0 ? Figure11Texts.NoPictureBeyond : Figure11Texts.NoScatterWithin);
        var together = measure(Spread.Within(beyond));
        var measured = Figure11Texts.Measured(Text(together), Text(measure(within)));
        var alone = beyond.Select(group => (group.Name, Ms: measure(Spread.Of(group.VisuMs)))).Where(group => group.Ms < minMs).ToArray();
        return new(statement, together >= minMs, alone.Length == 0 || beyond.Count == 1 ? measured
            : Figure11Texts.IndividuallyTooSmall(measured, string.Join(", ", alone.Select(group => $"{group.Name} ({Text(group.Ms)} ms)"))));
    }
}
