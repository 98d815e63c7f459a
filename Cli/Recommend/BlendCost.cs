using Nowpose.Session;

namespace Nowpose.Cli.Recommend;

/// <summary>The increase of the error if the recommended predictor blends consecutive sections to avoid jumps.</summary>
/// <remarks>A blend never reduces the error, so it cannot be selected by its error. It is recommended unless the error increases too much.</remarks>
sealed class BlendCost
{
    /// <summary>Maximum accepted increase, relative to the RMS error.</summary>
    public const double MaxShare = 0.05;

    /// <summary>Number of runs for one recommendation: without and with the blend.</summary>
    public const int Runs = 2;

    /// <param name="report">Called after each finished run.</param>
    public BlendCost(Recommendation recommendation, Action report, CancellationToken cancellation)
    {
        var plain = Try(recommendation, 0, report, cancellation);
        var blended = Try(recommendation, PredictionSettings.DefaultBlendMs, report, cancellation);
        if (plain == null || blended == null) return;
        RecommendedMs = -blended.GainOver(plain) > MaxShare ? 0 : PredictionSettings.DefaultBlendMs;
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

    /// <summary>Recommended time constant of the blend, ms; null after a cancellation.</summary>
    public double? RecommendedMs { get; }

    static Trial Try(Recommendation recommendation, double blendMs, Action report, CancellationToken cancellation)
    {
        if (cancellation.IsCancellationRequested) return null;
        var (subject, predictor) = (recommendation.Subject, recommendation.Recommended.Predictor);
        try
        {
            var trial = subject.Try(predictor, blendMs, cancellation);
            report();
            return trial;
        }
        catch (OperationCanceledException)
        {
            return null;
        }
    }
}
