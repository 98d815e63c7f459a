using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>A recording under one condition, on whose halves predictors are tried. Any thread, many at a time.</summary>
interface ISubject
{
    /// <summary>T_s in ms; null where the recording has its own.</summary>
    double? SamplingMs { get; }

    /// <summary>L in ms; null where the recording has its own.</summary>
    double? LatencyMs { get; }

    /// <param name="blendMs">Time constant from one section to the next; null for the recording's own, which a motion has none of.</param>
    /// <exception cref="InputException">Nothing could be scored.</exception>
    ReplayResult Try(string predictor, Half half, double? blendMs = null, CancellationToken cancellation = default);
}
