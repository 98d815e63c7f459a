using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>A recording under one condition, on whose halves predictors are tried. Thread-safe.</summary>
interface ISubject
{
    /// <summary>T_s in ms; null if the recording has its own.</summary>
    double? SamplingMs { get; }

    /// <summary>L in ms; null if the recording has its own.</summary>
    double? LatencyMs { get; }

    /// <param name="blendMs">Time constant of the blend between sections; null for the recording's own value, which is none for a motion.</param>
    /// <exception cref="InputException">No frame could be scored.</exception>
    ReplayResult Try(string predictor, Half half, double? blendMs = null, CancellationToken cancellation = default);
}
