using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>Fig. 14: quadratics fitted to more than the minimum number of samples (h = 3 and h = 4), compared with h = 2.</summary>
static class Figure14
{
    static readonly string[] ByHistory = ["quadratic", "quadratic-h3", "quadratic-h4"];

    public static readonly SweepClaims A = LongerIsWorse("14a", "Approximating quadratics over the sampling interval", "For any T_s");

    public static readonly SweepClaims B = LongerIsWorse("14b", "Approximating quadratics over the latency", "For any latency");

    public static readonly SweepClaims C = LongerIsWorse("14c", "Approximating quadratics over the error of the latency", "For any error of the latency");

    public static readonly SweepClaims D = new(
        "14d", "Approximating quadratics over the error of the sampling time",
        "A longer history makes the quadratic far more robust against errors of the assumed t_k.",
        data =>
        [
            new("At ±10 ms h = 4 is better than h = 3, and h = 3 better than h = 2.",
                data.RmsAt("quadratic-h4", 10) < data.RmsAt("quadratic-h3", 10) && data.RmsAt("quadratic-h3", 10) < data.RmsAt("quadratic", 10),
                string.Join(", ", ByHistory.Select(p => $"{p} {Mm(data.RmsAt(p, 10))}"))),
            new("At ±10 ms the error with h = 3 and with h = 4 is less than half of the error with h = 2.",
                2 * data.Growth("quadratic-h3", 0, 10) < data.Growth("quadratic", 0, 10)
                    && 2 * data.Growth("quadratic-h4", 0, 10) < data.Growth("quadratic", 0, 10),
                string.Join(", ", ByHistory.Select(p => $"{p} × {Text(data.Growth(p, 0, 10))}"))
                    + $"; h = 3 wins from ±{Crossover(data, "quadratic-h3", "quadratic")}, h = 4 over h = 3 from ±{Crossover(data, "quadratic-h4", "quadratic-h3")}"),
        ])
    { Compared = ByHistory };

    static SweepClaims LongerIsWorse(string number, string title, string where) => new(
        number, title, $"{where} a longer history predicts less accurately, as long as t_k is exact.",
        data => [Worse(data, "quadratic-h3", "quadratic", "h = 3 is less accurate than h = 2"),
            Worse(data, "quadratic-h4", "quadratic-h3", "h = 4 is less accurate than h = 3")])
    { Compared = ByHistory };

    static Criterion Worse(SweepData data, string longer, string shorter, string words)
    {
        var exceptions = data.Where(i => data.RmsMm(longer)[i] <= data.RmsMm(shorter)[i]);
        var ratios = Enumerable.Range(0, data.Values.Count).Select(i => data.RmsMm(longer)[i] / data.RmsMm(shorter)[i]).ToArray();
        return new($"Everywhere {words}.", exceptions.Length == 0,
            $"{Text(ratios.Min())} to {Text(ratios.Max())} × its error" + (exceptions.Length == 0 ? "" : $"; not at {SweepData.List(exceptions)}"));
    }

    static string Crossover(SweepData data, string winner, string loser) =>
        data.Crossover(winner, loser) is double ms ? Text(ms) + " ms" : "nowhere";
}
