namespace Nowpose.Cli.Figures.Model;

/// <summary>Whether the numbers support a claim.</summary>
enum Verdict
{
    Holds,
    HoldsPartly,
    DoesNotHold,
    NotMeasured,
}
