namespace Nowpose.Cli.Figures.Model;

/// <summary>One condition of a claim, and whether the measured numbers meet it.</summary>
/// <param name="Statement">The condition, including its thresholds.</param>
/// <param name="IsMet">Whether the condition is met; null if it was not measured, or if it is undecided.</param>
/// <param name="Measured">The measured numbers, or the reason why there are none.</param>
sealed record Criterion(string Statement, bool? IsMet, string Measured)
{
    /// <summary>Whether the condition is met for a part of the measured value's confidence interval only.</summary>
    public bool IsUndecided { get; init; }

    /// <summary>
    /// Judges a claim. It holds if all criteria are met, holds partly if some are met, and does not hold if none is met. If a criterion is undecided
    /// and no other one fails, the claim is undecided. If no criterion was measured, the claim is not judged.
    /// </summary>
    /// <param name="criteria">One criterion or more.</param>
    public static Verdict Judge(IReadOnlyCollection<Criterion> criteria)
    {
        if (criteria.Count == 0) throw new ArgumentException(FigureErrors.NoCriterion, nameof(criteria));
        if (criteria.All(c => c.IsMet == null && !c.IsUndecided)) return Verdict.NotMeasured;
        if (criteria.All(c => c.IsMet == true)) return Verdict.Holds;
        if (criteria.Any(c => c.IsUndecided) && criteria.All(c => c.IsMet != false)) return Verdict.Undecided;
        return criteria.Any(c => c.IsMet == true) ? Verdict.HoldsPartly : Verdict.DoesNotHold;
    }
}
