using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>A recording under one condition, on which predictors are evaluated. Thread-safe.</summary>
interface ISubject
{
    /// <summary>Sampling interval T_s, ms; null if the recording defines it.</summary>
    double? SamplingMs { get; }

    /// <summary>End-to-end latency L, ms; null if the recording defines it.</summary>
    double? LatencyMs { get; }

    /// <summary>Frames per second; null if the recording defines them.</summary>
    double? Fps { get; }

    /// <summary>Number of start phases of the frames; null if the recording defines the frames.</summary>
    int? Phases { get; }

    /// <summary>
    /// Replays the recording once with a predictor. The errors of the halves are separate, but the predictor keeps what it has learned.
    /// </summary>
    /// <param name="blendMs">Time constant of the blend between sections, ms. If null, the recorded value is used, which is 0 for a motion.</param>
    /// <exception cref="InputException">No frame of a half could be scored.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled.</exception>
    Trial Try(string predictor, double? blendMs = null, CancellationToken cancellation = default);
}
