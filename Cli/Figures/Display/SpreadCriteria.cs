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

    /// <param name="where">Where L_visu scatters, at the beginning of a sentence, for example "At 1 500 000".</param>
    /// <param name="inside">L_visu of all pictures inside the range, ms.</param>
    /// <param name="beyond">L_visu beyond the range, ms: one group of pictures for each load that is judged alone; none if there is none.</param>
    public static IEnumerable<Criterion> Of(string where, IEnumerable<double> inside, IReadOnlyCollection<IEnumerable<double>> beyond)
    {
        var within = Spread.Of(inside);
        var spreads = beyond.Select(Spread.Of).DefaultIfEmpty().ToArray();
        double deviation = spreads.Min(each => each.Deviation), range = spreads.Min(each => each.Range);
        yield return new($"{where} the standard deviation of L_visu is at least {Factor} times that within the range, each of the middle 95 %.",
            within.Deviation > 0 && deviation >= Factor * within.Deviation, $"{Text(deviation)} and {Text(within.Deviation)} ms");
        yield return new($"{where} the middle 95 % of L_visu extend over at least {Percent(RefreshShare)} of a refresh interval.",
            range >= RefreshShare * DisplayConditions.RefreshMs,
            $"{Text(range)} of {Text(DisplayConditions.RefreshMs)} ms; within the range {Text(within.Range)} ms");
    }
}
