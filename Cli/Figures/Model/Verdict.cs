namespace Nowpose.Cli.Figures.Model;

/// <summary>Result of judging a claim.</summary>
enum Verdict
{
    Holds,
    HoldsPartly,
    DoesNotHold,
    NotMeasured,

    /// <summary>The confidence interval of a measured value contains the limit.</summary>
    Undecided,
}
