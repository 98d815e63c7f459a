using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>A recording under one condition, on which predictors are evaluated. Thread-safe.</summary>
interface ISubject
{
    /// <summary>Sampling interval T_s, ms; null if the recording defines it.</summary>
    double? SamplingMs { get; }

    /// <summary>End-to-end latency L, ms; null if the recording defines it.</summary>
    double? LatencyMs { get; }

    /// <param name="blendMs">Time constant of the blend between sections, ms. If null, the recorded value is used, which is 0 for a motion.</param>
    /// <exception cref="InputException">No frame could be scored.</exception>
    ReplayResult Try(string predictor, Half half, double? blendMs = null, CancellationToken cancellation = default);
}
