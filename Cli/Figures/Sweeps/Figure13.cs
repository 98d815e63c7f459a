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
        "13a", "Interpolating polynomials over the sampling interval",
        "Over large parts of the range of T_s the quadratic predicts best, and the cubic is more sensitive to a longer T_s.",
        data =>
        {
            var quadratic = data.Where(i => data.Best(i, Polynomials) == "quadratic");
            var slow = data.Values.Where(v => v >= UsualSampling).ToArray();
            var cubic = data.Where(i => data.Best(i, Polynomials) == "cubic");
            return
            [
                new("The quadratic is the best of the three at each T_s of 50 ms and more.",
                    slow.All(quadratic.Contains), $"best at {SweepData.List(quadratic)}"),
                new(
                    "The quadratic is also the best below 50 ms.", quadratic.Length == data.Values.Count,
                    $"the cubic is better at {SweepData.List(cubic)}"),
                new("From 20 to 100 ms the cubic's error grows more than the quadratic's.",
                    data.Growth("cubic", 20, 100) > data.Growth("quadratic", 20, 100),
                    $"cubic × {Text(data.Growth("cubic", 20, 100))}, quadratic × {Text(data.Growth("quadratic", 20, 100))}"),
            ];
        })
    { Compared = Polynomials };

    public static readonly SweepClaims B = new(
        "13b", "Interpolating polynomials over the latency",
        "At every latency, the most accurate predictions are those of the quadratic and the cubic.",
        data =>
        [
            BestIsCurved(data, data.Values, "at each latency"),
            CubicBeatsLine(data),
        ])
    { Compared = Polynomials };

    public static readonly SweepClaims C = new(
        "13c", "Interpolating polynomials over the error of the latency",
        "At every error of the latency, the most accurate predictions are those of the quadratic and the cubic.",
        data =>
        [
            BestIsCurved(data, [.. data.Values.Where(v => Math.Abs(v) <= 20)], "at each error up to ±20 ms"),
            BestIsCurved(data, data.Values, "at each error up to ±50 ms"),
        ])
    { Compared = Polynomials };

    public static readonly SweepClaims D = new(
        "13d", "Interpolating polynomials over the error of the sampling time",
        "The quadratic and the cubic are sensitive to errors of the assumed t_k.",
        data =>
        [
            Reacts(data, "quadratic", 1.5),
            Reacts(data, "cubic", 1.5),
            new("At ±10 ms the line is the best of the three.", data.Best(data.Values.Count - 1, Polynomials) == "linear",
                string.Join(", ", Polynomials.Select(p => $"{p} {Mm(data.RmsAt(p, data.Values[^1]))}"))),
        ])
    { Compared = Polynomials };

    static Criterion BestIsCurved(SweepData data, IReadOnlyList<double> over, string where)
    {
        var linear = data.Where(i => over.Contains(data.Values[i]) && data.Best(i, Polynomials) == "linear");
        return new($"The best of the three is the quadratic or the cubic {where}.", linear.Length == 0,
            linear.Length == 0 ? "it is" : $"the line is better than both at {SweepData.List(linear)}");
    }

    static Criterion CubicBeatsLine(SweepData data)
    {
        var worse = data.Where(i => data.RmsMm("cubic")[i] > data.RmsMm("linear")[i]);
        return new("The cubic is also better than the line at each latency.", worse.Length == 0,
            worse.Length == 0 ? "it is" : $"worse at {SweepData.List(worse)}");
    }

    static Criterion Reacts(SweepData data, string predictor, double factor)
    {
        var growth = data.Growth(predictor, 0, 5);
        return new($"±5 ms multiply the {predictor}'s error by {Text(factor)} or more.", growth >= factor, $"× {Text(growth)}");
    }
}
