using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Messages;

/// <summary>Gets verdicts as text.</summary>
static class VerdictNames
{
    public static string Words(this Verdict verdict) => verdict switch
    {
        Verdict.Holds => "holds",
        Verdict.HoldsPartly => "holds partly",
        Verdict.NotMeasured => "not measured",
        Verdict.Undecided => "undecided",
        _ => "does not hold",
    };
}
