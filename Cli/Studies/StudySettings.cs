namespace Nowpose.Cli.Studies;

/// <summary>Conditions of a prediction. The defaults are the paper's values: T_s 50 ms, L 100 ms, 60 frames per second.</summary>
public sealed record StudySettings
{
    /// <summary>Sampling interval T_s, s.</summary>
    public double SamplingInterval { get; init; } = 0.050;

    /// <summary>Latency L from t_k to the first display time that can show the sample, s. Frames are identified by their display time.</summary>
    public double Latency { get; init; } = 0.100;

    public double FrameRateHz { get; init; } = 60;

    /// <summary>Error ε_L of the latency, s. It is added to the time of the prediction; positive if the latency is overestimated.</summary>
    public double LatencyError { get; init; }

    /// <summary>Maximum error ε_t of the time stamp t_k of a sample, s. The errors are uniformly distributed from minus to plus this value.</summary>
    public double StampError { get; init; }

    /// <summary>
    /// Maximum deviation of a sampling instant from its time stamp, s, uniformly distributed. The time stamps stay on the regular grid.
    /// </summary>
    public double SamplingJitter { get; init; }

    /// <summary>
    /// Maximum deviation of a sampling instant from the regular grid, s, uniformly distributed. The time stamp includes the deviation.
    /// </summary>
    public double StampedJitter { get; init; }

    /// <summary>
    /// Median of a log-normal delay that is added to the latency of each sample, s; 0 adds no delay. Samples can overtake each other.
    /// </summary>
    public double DelayMedian { get; init; }

    /// <summary>Maximum of the added delay, s.</summary>
    public double DelayMaximum { get; init; } = 0.120;

    /// <summary>Probability that a sample is lost.</summary>
    public double Loss { get; init; }

    /// <summary>Standard deviation of normally distributed noise on the sampled positions, in the unit of the motion.</summary>
    public double Noise { get; init; }

    /// <summary>Whether samples contain the velocity of the motion.</summary>
    public bool HasVelocity { get; init; }

    public bool HasAcceleration { get; init; }

    /// <summary>Time before which frames are not scored, s.</summary>
    public double WarmUp { get; init; } = 1.2;

    /// <summary>Number of runs, each with random phases of the sampling and of the frames. The phases alone can change a ratio by 10 %.</summary>
    public int Phases { get; init; } = 8;

    public int Seed { get; init; } = 1;
}
