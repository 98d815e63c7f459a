using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>A claim of the paper about one panel of a sweep, and the criteria that decide whether it holds.</summary>
sealed record SweepClaims(string Number, string Title, string Claim, Func<SweepData, IReadOnlyList<Criterion>> Criteria)
{
    /// <summary>The predictors that the paper compares in this figure.</summary>
    public required IReadOnlyList<string> Compared { get; init; }
}
