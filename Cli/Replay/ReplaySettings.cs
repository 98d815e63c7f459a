namespace Nowpose.Cli.Replay;

/// <summary>The conditions of one replay, from the command line, which has checked their ranges.</summary>
public sealed class ReplaySettings
{
    /// <summary>T_s in seconds.</summary>
    public double SamplingInterval { get; init; } = 0.050;

    /// <summary>L in seconds, from a sample's t_k to its arrival.</summary>
    public double Latency { get; init; } = 0.100;

    /// <summary>Frames per second.</summary>
    public double FrameRateHz { get; init; } = 60;

    /// <summary>A name of <see cref="Nowpose.Prediction.Predictors"/>.</summary>
    public string Predictor { get; init; } = Nowpose.Prediction.Predictors.Default;

    /// <summary>ε_L in seconds, added to the time of the prediction.</summary>
    public double LatencyError { get; init; }

    /// <summary>Half-width in seconds of the uniform error ε_t of each t_k.</summary>
    public double StampError { get; init; }

    /// <summary>Maximum additional delay of a sample in seconds, uniform from 0.</summary>
    public double Jitter { get; init; }

    /// <summary>Probability, 0 to 1, that a sample never arrives.</summary>
    public double Loss { get; init; }

    /// <summary>
    /// Time constant in seconds of the transition to a new section; 0 for a jump. Null for the recorded value, which is 0 for a motion.
    /// </summary>
    public double? Blend { get; init; }

    /// <summary>Whether the recorded session's set-points are used where the session used them; false to ignore them.</summary>
    public bool FollowPlan { get; init; } = true;

    public int Seed { get; init; } = 1;
}
