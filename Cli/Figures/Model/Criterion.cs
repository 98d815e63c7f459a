using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Figures.Model;

/// <summary>A condition of a claim, and whether the numbers meet it.</summary>
/// <param name="Statement">The condition, including its thresholds.</param>
/// <param name="IsMet">Null if the numbers were not measured.</param>
/// <param name="Measured">The measured numbers, or why there are none.</param>
sealed record Criterion(string Statement, bool? IsMet, string Measured)
{
    /// <summary>
    /// Judges a claim: it holds if all criteria are met, holds partly if some are, and does not hold if none is. Without any measured
    /// number it is not judged.
    /// </summary>
    /// <param name="criteria">At least one criterion.</param>
    public static Verdict Judge(IReadOnlyCollection<Criterion> criteria)
    {
        if (criteria.Count == 0) throw new ArgumentException(FigureErrors.NoCriterion, nameof(criteria));
        if (criteria.All(c => c.IsMet == null)) return Verdict.NotMeasured;
        if (criteria.All(c => c.IsMet == true)) return Verdict.Holds;
        return criteria.Any(c => c.IsMet == true) ? Verdict.HoldsPartly : Verdict.DoesNotHold;
    }
}
