using System.Text.Json.Serialization;

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

    /// <summary>Smallest possible value; 0 for a share of a whole. A reduction may be negative.</summary>
    [JsonIgnore]
    public double Min { get; init; } = double.NegativeInfinity;

    /// <summary>Largest possible value; 1 for a share of a whole and for a reduction.</summary>
    [JsonIgnore]
    public double Max { get; init; } = double.PositiveInfinity;

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

    string Interval(double value, double half) => value - half < Min || value + half > Max
        ? PaperClaimTexts.Clipped(Text(value), Text(Math.Max(Min, value - half)), Text(Math.Min(Max, value + half)))
        : $"{Text(value)} ± {Text(half)}";

    string Text(double value) => Unit == "ms" ? Figures.Numbers.Text(value) + " ms" : Figures.Numbers.Percent(value);
}
