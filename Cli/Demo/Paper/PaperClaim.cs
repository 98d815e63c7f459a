using System.Text.Json.Serialization;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>One claim of the paper with its number and ours, as in result.json.</summary>
/// <param name="Figure">Number of the figure in the paper.</param>
/// <param name="Claim">The claim with its condition and the definition of the measured number.</param>
/// <param name="Paper">The paper's number; null where it gives none.</param>
/// <param name="Measured">Our number, the mean over the repeats; null if it could not be measured.</param>
/// <param name="Uncertainty">Half of the 95 % confidence interval of the mean over the repeats; null for a single repeat.</param>
/// <param name="Unit">Unit of the numbers: <c>ms</c>, or <c>share</c> for a ratio.</param>
sealed record PaperClaim(string Figure, string Claim, double? Paper, double? Measured, double? Uncertainty, string Unit, bool Holds)
{
    /// <summary>Why all or some of the repeats did not measure the number; null if all did.</summary>
    public string NotMeasured { get; init; }

    /// <summary>The measured number with unit and uncertainty, for readers.</summary>
    [JsonIgnore]
    public string MeasuredText => Measured is not double value ? NotMeasured
        : (Uncertainty is double half ? $"{Text(value)} ± {Text(half)}" : Text(value)) + (NotMeasured == null ? "" : $" ({NotMeasured})");

    /// <summary>The verdict for readers.</summary>
    [JsonIgnore]
    public string Verdict => Measured == null ? "not measured" : Holds ? "holds" : "does not hold";

    /// <summary>The paper's number with its unit; empty where it gives none.</summary>
    [JsonIgnore]
    public string PaperText => Paper is double value ? Text(value) : "";

    string Text(double value) => Unit == "ms" ? Figures.Numbers.Text(value) + " ms" : Figures.Numbers.Percent(value);
}
