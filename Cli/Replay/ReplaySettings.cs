namespace Nowpose.Cli.Replay;

/// <summary>Conditions of a replay. The command line checks their ranges.</summary>
public sealed class ReplaySettings
{
    /// <summary>Sampling interval T_s, s.</summary>
    public double SamplingInterval { get; init; } = 0.050;

    /// <summary>Latency L from the t_k of a sample to its arrival, s.</summary>
    public double Latency { get; init; } = 0.100;

    /// <summary>Frames per second.</summary>
    public double FrameRateHz { get; init; } = 60;

    /// <summary>
    /// Number of passes over a motion. Pass k, from 0, delays all frames by the share k / number of the frame interval.
    /// </summary>
    public int Phases { get; init; } = 1;

    /// <summary>Name of the predictor, from <see cref="Nowpose.Prediction.Predictors"/>.</summary>
    public string Predictor { get; init; } = Nowpose.Prediction.Predictors.Default;

    /// <summary>Error ε_L of the latency, s. It is added to the time for which the position is predicted.</summary>
    public double LatencyError { get; init; }

    /// <summary>Half the width of the uniform distribution of the errors ε_t of t_k, s.</summary>
    public double StampError { get; init; }

    /// <summary>Maximum additional delay of a sample, s. The delay is distributed uniformly from 0.</summary>
    public double Jitter { get; init; }

    /// <summary>Probability that a sample is lost, 0 to 1.</summary>
    public double Loss { get; init; }

    /// <summary>
    /// Time constant of the blend to a new section, s; 0 for no blend. Null to use the recorded value, which is 0 for a motion.
    /// </summary>
    public double? Blend { get; init; }

    /// <summary>Whether the replay uses the recorded set-points in the same way as the session. If false, it ignores them.</summary>
    public bool FollowPlan { get; init; } = true;

    public int Seed { get; init; } = 1;
}
