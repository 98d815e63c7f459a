using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>What the paper says of one figure of a sweep, and what decides whether it holds.</summary>
sealed record SweepClaims(string Number, string Title, string Claim, Func<SweepData, IReadOnlyList<Criterion>> Criteria)
{
    /// <summary>The predictors that the paper compares there.</summary>
    public required IReadOnlyList<string> Compared { get; init; }
}
