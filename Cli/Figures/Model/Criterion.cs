namespace Nowpose.Cli.Figures.Model;

/// <summary>One thing that must be so for a claim to hold, and whether the numbers say that it is.</summary>
/// <param name="Statement">What is asked of the numbers, thresholds included.</param>
/// <param name="Measured">The numbers themselves.</param>
sealed record Criterion(string Statement, bool IsMet, string Measured)
{
    /// <summary>All met: the claim holds; none: it does not; else partly.</summary>
    /// <param name="criteria">At least one.</param>
    public static Verdict Judge(IReadOnlyCollection<Criterion> criteria)
    {
        if (criteria.Count == 0) throw new ArgumentException("a claim without a criterion cannot be judged", nameof(criteria));
        if (criteria.All(c => c.IsMet)) return Verdict.Holds;
        return criteria.Any(c => c.IsMet) ? Verdict.HoldsPartly : Verdict.DoesNotHold;
    }
}
