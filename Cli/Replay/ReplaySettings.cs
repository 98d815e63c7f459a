namespace Nowpose.Cli.Replay;

/// <summary>The conditions of one replay, as the command line gives them; ranges are checked there.</summary>
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

    /// <summary>ε_L in seconds, added to the time the predictor is asked for.</summary>
    public double LatencyError { get; init; }

    /// <summary>Half-width in seconds of the uniform error ε_t on each t_k told.</summary>
    public double StampError { get; init; }

    /// <summary>Greatest additional delay of a sample in seconds, uniform from 0.</summary>
    public double Jitter { get; init; }

    /// <summary>Probability, 0 to 1, that a sample never arrives.</summary>
    public double Loss { get; init; }

    /// <summary>Time constant in seconds within which a new section replaces the old one; 0 leaves the jump. Null: as it was recorded, 0 for a motion.</summary>
    public double? Blend { get; init; }

    /// <summary>Whether the set-points of a recorded session are followed where it followed them; false: they are left out.</summary>
    public bool FollowPlan { get; init; } = true;

    public int Seed { get; init; } = 1;
}
