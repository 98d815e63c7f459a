using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>Fig. 14: quadratics fitted to more than the minimum number of samples (h = 3 and h = 4), compared with h = 2.</summary>
static class Figure14
{
    static readonly string[] ByHistory = ["quadratic", "quadratic-h3", "quadratic-h4"];

    public static readonly SweepClaims A = LongerIsWorse("14a", Figure14Texts.OverSampling, "For any T_s");

    public static readonly SweepClaims B = LongerIsWorse("14b", Figure14Texts.OverLatency, "For any latency");

    public static readonly SweepClaims C = LongerIsWorse("14c", Figure14Texts.OverLatencyError, Figure14Texts.AnyLatencyError);

    public static readonly SweepClaims D = new(
        "14d", Figure14Texts.OverSamplingError,
        Figure14Texts.OverSamplingErrorClaim,
        data =>
        [
            new(Figure14Texts.LongerIsBetter,
                data.RmsAt("quadratic-h4", 10) < data.RmsAt("quadratic-h3", 10) && data.RmsAt("quadratic-h3", 10) < data.RmsAt("quadratic", 10),
                string.Join(", ", ByHistory.Select(p => $"{p} {Mm(data.RmsAt(p, 10))}"))),
            new(Figure14Texts.HalfTheError,
                2 * data.Growth("quadratic-h3", 0, 10) < data.Growth("quadratic", 0, 10)
                    && 2 * data.Growth("quadratic-h4", 0, 10) < data.Growth("quadratic", 0, 10),
                Figure14Texts.Growth(string.Join(", ", ByHistory.Select(p => $"{p} × {Text(data.Growth(p, 0, 10))}")), Crossover(data, "quadratic-h3", "quadratic"), Crossover(data, "quadratic-h4", "quadratic-h3"))),
        ])
    { Compared = ByHistory };

    static SweepClaims LongerIsWorse(string number, string title, string where) => new(
        number, title, Figure14Texts.LongerIsWorse(where),
        data => [Worse(data, "quadratic-h3", "quadratic", Figure14Texts.ThreeIsWorse),
            Worse(data, "quadratic-h4", "quadratic-h3", Figure14Texts.FourIsWorse)])
    { Compared = ByHistory };

    static Criterion Worse(SweepData data, string longer, string shorter, string words)
    {
        var exceptions = data.Where(i => data.RmsMm(longer)[i] <= data.RmsMm(shorter)[i]);
        var ratios = Enumerable.Range(0, data.Values.Count).Select(i => data.RmsMm(longer)[i] / data.RmsMm(shorter)[i]).ToArray();
        return new($"{words} everywhere.", exceptions.Length == 0,
            $"{Text(ratios.Min())} to {Text(ratios.Max())} × its error" + (exceptions.Length == 0 ? "" : $"; not at {SweepData.List(exceptions)}"));
    }

    static string Crossover(SweepData data, string winner, string loser) =>
        data.Crossover(winner, loser) is double ms ? Figure14Texts.From(Text(ms)) : Figure14Texts.Never;
}
