using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Figures.Model;

/// <summary>One condition of a claim, and whether the measured numbers meet it.</summary>
/// <param name="Statement">The condition, including its thresholds.</param>
/// <param name="IsMet">Whether the condition is met; null if it was not measured.</param>
/// <param name="Measured">The measured numbers, or the reason why there are none.</param>
sealed record Criterion(string Statement, bool? IsMet, string Measured)
{
    /// <summary>
    /// Judges a claim. It holds if all criteria are met, holds partly if some are met, and does not hold if none is met. If no criterion was
    /// measured, the claim is not judged.
    /// </summary>
    /// <param name="criteria">One criterion or more.</param>
    public static Verdict Judge(IReadOnlyCollection<Criterion> criteria)
    {
        if (criteria.Count == 0) throw new ArgumentException(FigureErrors.NoCriterion, nameof(criteria));
        if (criteria.All(c => c.IsMet == null)) return Verdict.NotMeasured;
        if (criteria.All(c => c.IsMet == true)) return Verdict.Holds;
        return criteria.Any(c => c.IsMet == true) ? Verdict.HoldsPartly : Verdict.DoesNotHold;
    }
}
