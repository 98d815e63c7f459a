using Nowpose.Session;

namespace Nowpose.Cli.Recommend;

/// <summary>What it costs to let sections of the recommended predictor give way to each other without a jump.</summary>
/// <remarks>A blend never helps the error, so that it cannot be chosen by it: it is kept unless it costs too much.</remarks>
sealed class BlendCost
{
    /// <summary>More than this share of the RMS error is too much for the eye's comfort.</summary>
    public const double Greatest = 0.05;

    public BlendCost(Verdict verdict, CancellationToken cancellation)
    {
        var (plain, blended) = (Try(verdict, 0, cancellation), Try(verdict, PredictionSettings.DefaultBlendMs, cancellation));
        if (plain == null || blended == null) return;
        Share = -blended.GainOver(plain);
        ShareOfHalves = [-blended.GainOver(plain, Half.First), -blended.GainOver(plain, Half.Second)];
    }

    /// <summary>By how much the RMS error grows with the default blend, over both halves; null where there is no error, or when interrupted.</summary>
    public double? Share { get; }

    /// <summary>The same of each half.</summary>
    public IReadOnlyList<double?> ShareOfHalves { get; } = [null, null];

    /// <summary>Time constant to use, ms.</summary>
    public double RecommendedMs => Share > Greatest ? 0 : PredictionSettings.DefaultBlendMs;

    static Trial Try(Verdict verdict, double blendMs, CancellationToken cancellation)
    {
        if (cancellation.IsCancellationRequested) return null;
        var predictor = verdict.Recommended.Predictor;
        var first = verdict.Subject.Try(predictor, Half.First, blendMs, CancellationToken.None);
        return new Trial(predictor, first, verdict.Subject.Try(predictor, Half.Second, blendMs, CancellationToken.None));
    }
}
