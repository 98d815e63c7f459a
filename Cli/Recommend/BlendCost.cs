using Nowpose.Session;

namespace Nowpose.Cli.Recommend;

/// <summary>The increase of the error if the recommended predictor blends consecutive sections to avoid jumps.</summary>
/// <remarks>A blend never reduces the error, so it cannot be selected by its error. It is recommended unless the error increases too much.</remarks>
sealed class BlendCost
{
    /// <summary>Maximum accepted increase, relative to the RMS error.</summary>
    public const double MaxShare = 0.05;

    public BlendCost(Recommendation recommendation, CancellationToken cancellation)
    {
        var (plain, blended) = (Try(recommendation, 0, cancellation), Try(recommendation, PredictionSettings.DefaultBlendMs, cancellation));
        if (plain == null || blended == null) return;
        Share = -blended.GainOver(plain);
        ShareOfHalves = [-blended.GainOver(plain, Half.First), -blended.GainOver(plain, Half.Second)];
    }

    /// <summary>
    /// Relative increase of the RMS error with the default blend, over both halves; null if the error without a blend is zero, or after a
    /// cancellation.
    /// </summary>
    public double? Share { get; }

    /// <summary>Relative increase of the RMS error for each half of the recording.</summary>
    public IReadOnlyList<double?> ShareOfHalves { get; } = [null, null];

    /// <summary>Recommended time constant of the blend, ms.</summary>
    public double RecommendedMs => Share > MaxShare ? 0 : PredictionSettings.DefaultBlendMs;

    static Trial Try(Recommendation recommendation, double blendMs, CancellationToken cancellation)
    {
        if (cancellation.IsCancellationRequested) return null;
        var predictor = recommendation.Recommended.Predictor;
        var first = recommendation.Subject.Try(predictor, Half.First, blendMs, CancellationToken.None);
        return new Trial(predictor, first, recommendation.Subject.Try(predictor, Half.Second, blendMs, CancellationToken.None));
    }
}
