namespace Nowpose.Cli.Demo.Paper;

/// <summary>A claim of the paper before it is measured.</summary>
/// <param name="Measure">Gets the number of one repeat; null if it was not measured.</param>
/// <param name="IsMet">Judges the mean of the repeats.</param>
sealed record PaperRule(string Figure, string Claim, double? Paper, string Unit, Func<PaperMeasures, double?> Measure, Func<double, bool> IsMet)
{
    /// <summary>Whether the number comes from whole swings.</summary>
    public bool NeedsSwings { get; init; }
}
