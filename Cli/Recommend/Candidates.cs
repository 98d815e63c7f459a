using Nowpose.Prediction;

namespace Nowpose.Cli.Recommend;

/// <summary>The candidates: every predictor that settings offer, and every degree with other histories.</summary>
static class Candidates
{
    const int MaxHistory = 6;

    static readonly string[] Degrees = ["linear", "quadratic", "cubic"];

    /// <summary>The names. The two that others are compared with come first, so that an interrupted run has a partial result.</summary>
    public static IReadOnlyList<string> Names { get; } =
        [.. new[] { Predictors.Default, "hold" }.Concat(Predictors.Names).Concat(Histories()).Distinct()];

    static IEnumerable<string> Histories()
    {
        for (var degree = 1; degree <= Degrees.Length; degree++)
            for (var history = degree + 1; history <= MaxHistory; history++)
                yield return FormattableString.Invariant($"{Degrees[degree - 1]}-h{history}");
    }
}
