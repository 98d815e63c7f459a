namespace Nowpose.Cli.Figures.Model;

/// <summary>What the numbers say of a claim.</summary>
enum Verdict
{
    Holds,
    HoldsPartly,
    DoesNotHold,
}
