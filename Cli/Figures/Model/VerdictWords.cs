namespace Nowpose.Cli.Figures.Model;

/// <summary>Verdicts as people read them.</summary>
static class VerdictWords
{
    public static string Words(this Verdict verdict) => verdict switch
    {
        Verdict.Holds => "holds",
        Verdict.HoldsPartly => "holds partly",
        _ => "does not hold",
    };
}
