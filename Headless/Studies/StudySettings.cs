namespace Nowpose.Studies;

/// <summary>Conditions of a prediction. The defaults are the paper's values: T_s 50 ms, L 100 ms, 60 frames per second.</summary>
public sealed record StudySettings
{
    /// <summary>Sampling interval T_s, s.</summary>
    public double SamplingInterval { get; init; } = 0.050;

    /// <summary>Latency L from t_k to the arrival of the sample, s. Frames are identified by their display time.</summary>
    public double Latency { get; init; } = 0.100;

    public double FrameRateHz { get; init; } = 60;

    /// <summary>Error ε_L of the latency, s. It is added to the time of the prediction; positive if the latency is overestimated.</summary>
    public double LatencyError { get; init; }

    /// <summary>Half the width of the uniform distribution of the error ε_t of each t_k, s.</summary>
    public double StampError { get; init; }

    /// <summary>Half the width of the uniform deviation of the sampling instants from the regular grid of the time stamps, s.</summary>
    public double SamplingJitter { get; init; }

    /// <summary>Half the width of the uniform deviation of the sampling instants if the time stamps contain the deviation, s.</summary>
    public double StampedJitter { get; init; }

    /// <summary>Median of a log-normal delay that is added to the latency of each sample, s; 0 for none. Samples can overtake each other.</summary>
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

    /// <summary>Number of runs with random phases of sampling and frames. The phase alone can change a ratio by 10 %.</summary>
    public int Phases { get; init; } = 8;

    public int Seed { get; init; } = 1;
}
