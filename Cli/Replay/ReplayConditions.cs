using Nowpose.Session;

namespace Nowpose.Cli.Replay;

/// <summary>The conditions of a replay, as in its JSON: the version of the program, and the main settings.</summary>
static class ReplayConditions
{
    const double MsPerSecond = 1000;

    public static object Of(ReplaySettings settings) => new
    {
        Version = ProgramVersion.Text, settings.Predictor,
        SamplingMs = settings.SamplingInterval * MsPerSecond, LatencyMs = settings.Latency * MsPerSecond,
        Fps = settings.FrameRateHz, settings.Phases, LatencyErrorMs = settings.LatencyError * MsPerSecond,
        StampErrorMs = settings.StampError * MsPerSecond, JitterMs = settings.Jitter * MsPerSecond, settings.Loss,
        BlendMs = (settings.Blend ?? 0) * MsPerSecond, settings.Seed,
    };

    /// <summary>Gets the conditions that a recorded session does not define, and its prediction settings.</summary>
    public static object Of(ReplaySettings settings, PredictionSettings recorded)
    {
        var prediction = SessionReplay.PredictionOf(recorded, settings);
        return new
        {
            Version = ProgramVersion.Text, prediction.Predictor, LatencyErrorMs = settings.LatencyError * MsPerSecond,
            StampErrorMs = settings.StampError * MsPerSecond, BlendMs = prediction.Blend.TotalMilliseconds,
            HorizonCapMs = prediction.HorizonCap.TotalMilliseconds, MaximumGapMs = prediction.MaximumGap.TotalMilliseconds, prediction.FollowPlan,
            settings.Seed,
        };
    }
}
