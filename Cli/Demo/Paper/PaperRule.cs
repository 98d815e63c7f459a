namespace Nowpose.Cli.Demo.Paper;

/// <summary>A claim of the paper, with the functions that measure and judge it.</summary>
/// <param name="Measure">Gets the value of one repeat; null if it was not measured.</param>
/// <param name="IsMet">Decides whether a value meets the claim: all values up to a limit, or all values from a limit on.</param>
sealed record PaperRule(string Figure, string Claim, double? Paper, string Unit, Func<PaperMeasures, double?> Measure, Func<double, bool> IsMet)
{
    /// <summary>Whether the value is measured over whole swings.</summary>
    public bool NeedsSwings { get; init; }
}
