namespace Nowpose.Cli.Figures.Model;

/// <summary>Gets verdicts as text.</summary>
static class VerdictWords
{
    public static string Words(this Verdict verdict) => verdict switch
    {
        Verdict.Holds => "holds",
        Verdict.HoldsPartly => "holds partly",
        Verdict.NotMeasured => "not measured",
        _ => "does not hold",
    };
}
