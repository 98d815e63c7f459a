using System.Text.Json.Serialization;
using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>One claim of the paper, with the paper's value and the measured one, as in result.json.</summary>
/// <param name="Figure">Number of the figure in the paper.</param>
/// <param name="Claim">The claim, with its condition and the definition of the measured value.</param>
/// <param name="Paper">The paper's value; null if the paper gives none.</param>
/// <param name="Measured">Mean of the measured values over all repeats; null if it could not be measured.</param>
/// <param name="Uncertainty">Half of the 95 % confidence interval of the mean; null for a single repeat.</param>
/// <param name="Unit">Unit of the values: <c>ms</c>, or <c>share</c> for a ratio.</param>
/// <param name="Holds">Whether the criterion is met for the mean and for its complete confidence interval.</param>
sealed record PaperClaim(string Figure, string Claim, double? Paper, double? Measured, double? Uncertainty, string Unit, bool Holds)
{
    /// <summary>The measured value of each complete repeat; null for a repeat without a value.</summary>
    public IReadOnlyList<double?> Repeats { get; init; } = [];

    /// <summary>Whether the value is a part of a whole, so that it lies between 0 and 1.</summary>
    [JsonIgnore]
    public bool IsPart { get; init; }

    /// <summary>Reason why some or all of the repeats have no value; null if all have one.</summary>
    public string NotMeasured { get; init; }

    /// <summary>Whether the criterion is met for a part of the confidence interval only.</summary>
    [JsonIgnore]
    public bool IsUndecided { get; init; }

    /// <summary>Text of the measured value with its unit and uncertainty.</summary>
    [JsonIgnore]
    public string MeasuredText => Measured is not double value ? NotMeasured
        : (Uncertainty is double half ? Interval(value, half) : Text(value)) + (NotMeasured == null ? "" : $" ({NotMeasured})");

    /// <summary>Text of the verdict.</summary>
    public string Verdict => (Measured == null ? Figures.Model.Verdict.NotMeasured
        : IsUndecided ? Figures.Model.Verdict.Undecided
        : Holds ? Figures.Model.Verdict.Holds : Figures.Model.Verdict.DoesNotHold).Words();

    /// <summary>Text of the paper's value with its unit; empty if the paper gives none.</summary>
    [JsonIgnore]
    public string PaperText => Paper is double value ? Text(value) : "";

    // A part of a whole is between 0 and 1, so its interval is, too.
    string Interval(double value, double half) => IsPart && (value - half < 0 || value + half > 1)
        ? PaperClaimTexts.Clipped(Text(value), Text(Math.Max(0, value - half)), Text(Math.Min(1, value + half)))
        : $"{Text(value)} ± {Text(half)}";

    string Text(double value) => Unit == "ms" ? Figures.Numbers.Text(value) + " ms" : Figures.Numbers.Percent(value);
}
