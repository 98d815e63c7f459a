namespace Nowpose.Cli;

/// <summary>Errors without and with compensation over the same frames. Their unit is that of the errors that were compared.</summary>
/// <param name="RmsHold">RMS error of hold.</param>
/// <param name="Rms">RMS error of the displayed values.</param>
/// <param name="P95">95th percentile of their absolute error.</param>
/// <param name="Max">Maximum of their absolute error.</param>
public readonly record struct ErrorComparison(double RmsHold, double Rms, double P95, double Max)
{
    /// <summary>1 − Rms / RmsHold; null if hold has no error.</summary>
    public double? Reduction => ErrorReduction.Of(Rms, RmsHold);

    /// <summary>Compares the errors of all frames; null if there are none.</summary>
    /// <param name="errors">The error of hold and that of the displayed value in each frame.</param>
    internal static ErrorComparison? Of(IEnumerable<(double Hold, double Displayed)> errors)
    {
        var collected = new ErrorCollector();
        foreach (var (hold, displayed) in errors) collected.Add(hold, displayed);
        return collected.Count == 0 ? null : collected.Result();
    }
}
