using Nowpose.Prediction;

namespace Nowpose.Cli.Recommend;

/// <summary>Lists the candidates: all predictors that can be selected in the settings, and polynomials with other history lengths.</summary>
static class Candidates
{
    const int MaxHistory = 6;

    static readonly string[] Degrees = ["linear", "quadratic", "cubic"];

    /// <summary>Names of the candidates. The two references come first, so that an interrupted run has a partial result.</summary>
    public static IReadOnlyList<string> Names { get; } =
        [.. new[] { Predictors.Default, "hold" }.Concat(Predictors.Names).Concat(Histories()).Distinct()];

    static IEnumerable<string> Histories()
    {
        for (var degree = 1; degree <= Degrees.Length; degree++)
            for (var history = degree + 1; history <= MaxHistory; history++)
                yield return FormattableString.Invariant($"{Degrees[degree - 1]}-h{history}");
    }
}
