using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>The result of one candidate on both halves. Errors are in the unit of the recording's axes.</summary>
sealed record Trial(string Predictor, ReplayResult First, ReplayResult Second)
{
    /// <summary>RMS error over the frames of both halves.</summary>
    public double Rms => Pooled(result => result.Rms);

    /// <summary>RMS error of hold over the frames of both halves.</summary>
    public double RmsHold => Pooled(result => result.RmsHold);

    /// <summary>1 − Rms / RmsHold; null if nothing moved.</summary>
    public double? Reduction => ErrorReduction.Of(Rms, RmsHold);

    /// <summary>Gets the relative reduction of the RMS error compared with another trial; 0.1 is 10 % less. Null if the other has no error.</summary>
    public double? GainOver(Trial other) => ErrorReduction.Of(Rms, other.Rms);

    /// <summary>Gets the relative reduction of the RMS error compared with another trial on one half. Null if the other has no error.</summary>
    public double? GainOver(Trial other, Half half) => ErrorReduction.Of(On(half).Rms, other.On(half).Rms);

    public bool IsBetterThan(Trial other, Half half) => On(half).Rms < other.On(half).Rms;

    public ReplayResult On(Half half) => half == Half.First ? First : Second;

    double Pooled(Func<ReplayResult, double> rms) => Math.Sqrt(
        (First.Frames * rms(First) * rms(First) + Second.Frames * rms(Second) * rms(Second)) / (First.Frames + Second.Frames));
}
