using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>Fig. 13: polynomials through the newest samples (h = n).</summary>
static class Figure13
{
    /// <summary>Sampling interval of the paper: the middle of its range, ms.</summary>
    const double UsualSampling = 50;

    static readonly string[] Polynomials = ["linear", "quadratic", "cubic"];

    public static readonly SweepClaims A = new(
        "13a", Figure13Texts.OverSampling,
        Figure13Texts.OverSamplingClaim,
        data =>
        {
            var quadratic = data.Where(i => data.Best(i, Polynomials) == "quadratic");
            var slow = data.Values.Where(v => v >= UsualSampling).ToArray();
            var cubic = data.Where(i => data.Best(i, Polynomials) == "cubic");
            return
            [
                new(Figure13Texts.QuadraticBest,
                    slow.All(quadratic.Contains), $"best at {SweepData.List(quadratic)}"),
                new(Figure13Texts.QuadraticBestBelow, quadratic.Length == data.Values.Count,
                    Figure13Texts.CubicBetter(SweepData.List(cubic))),
                new(Figure13Texts.CubicGrows,
                    data.Growth("cubic", 20, 100) > data.Growth("quadratic", 20, 100),
                    $"cubic × {Text(data.Growth("cubic", 20, 100))}, quadratic × {Text(data.Growth("quadratic", 20, 100))}"),
            ];
        })
    { Compared = Polynomials };

    public static readonly SweepClaims B = new(
        "13b", Figure13Texts.OverLatency,
        Figure13Texts.OverLatencyClaim,
        data =>
        [
            BestIsCurved(data, data.Values, "at each latency"),
            CubicBeatsLine(data),
        ])
    { Compared = Polynomials };

    public static readonly SweepClaims C = new(
        "13c", Figure13Texts.OverLatencyError,
        Figure13Texts.OverLatencyErrorClaim,
        data =>
        [
            BestIsCurved(data, [.. data.Values.Where(v => Math.Abs(v) <= 20)], Figure13Texts.Within20Ms),
            BestIsCurved(data, data.Values, Figure13Texts.Within50Ms),
        ])
    { Compared = Polynomials };

    public static readonly SweepClaims D = new(
        "13d", Figure13Texts.OverSamplingError,
        Figure13Texts.OverSamplingErrorClaim,
        data =>
        [
            Reacts(data, "quadratic", 1.5),
            Reacts(data, "cubic", 1.5),
            new(Figure13Texts.LineBest, data.Best(data.Values.Count - 1, Polynomials) == "linear",
                string.Join(", ", Polynomials.Select(p => $"{p} {Mm(data.RmsAt(p, data.Values[^1]))}"))),
        ])
    { Compared = Polynomials };

    static Criterion BestIsCurved(SweepData data, IReadOnlyList<double> over, string where)
    {
        var linear = data.Where(i => over.Contains(data.Values[i]) && data.Best(i, Polynomials) == "linear");
        return new(Figure13Texts.BestIsCurved(where), linear.Length == 0,
            linear.Length == 0 ? Figure13Texts.IsSo : Figure13Texts.LineBetter(SweepData.List(linear)));
    }

    static Criterion CubicBeatsLine(SweepData data)
    {
        var worse = data.Where(i => data.RmsMm("cubic")[i] > data.RmsMm("linear")[i]);
        return new(Figure13Texts.CubicBeatsLine, worse.Length == 0,
            worse.Length == 0 ? Figure13Texts.IsSo : Figure13Texts.WorseAt(SweepData.List(worse)));
    }

    static Criterion Reacts(SweepData data, string predictor, double factor)
    {
        var growth = data.Growth(predictor, 0, 5);
        return new(Figure13Texts.Reacts(predictor, Text(factor)), growth >= factor, $"× {Text(growth)}");
    }
}
