namespace Nowpose.Studies;

/// <summary>The conditions of a prediction. The defaults are the paper's: T_s 50 ms, L 100 ms, 60 frames a second.</summary>
public sealed record StudySettings
{
    /// <summary>T_s, s.</summary>
    public double SamplingInterval { get; init; } = 0.050;

    /// <summary>L, s, from t_k to the arrival of the sample. Frames are timed by their display time.</summary>
    public double Latency { get; init; } = 0.100;

    public double FrameRateHz { get; init; } = 60;

    /// <summary>ε_L, s, added to the time of the prediction; positive when the latency is overestimated.</summary>
    public double LatencyError { get; init; }

    /// <summary>Half-width of the uniform error ε_t of each stamp t_k, s.</summary>
    public double StampError { get; init; }

    /// <summary>Half-width of the uniform deviation of the true sampling instants from the stamps' grid, s.</summary>
    public double SamplingJitter { get; init; }

    /// <summary>The same deviation for a source whose stamps are the true instants, s.</summary>
    public double StampedJitter { get; init; }

    /// <summary>Median of a log-normal delay added to the latency of each sample, s; 0 for none. Samples overtake each other.</summary>
    public double DelayMedian { get; init; }

    /// <summary>Maximum added delay, s.</summary>
    public double DelayMaximum { get; init; } = 0.120;

    /// <summary>Probability that a sample never arrives.</summary>
    public double Loss { get; init; }

    /// <summary>Standard deviation of normal noise on the sampled positions, in the motion's unit.</summary>
    public double Noise { get; init; }

    /// <summary>Whether samples contain the velocity, and the acceleration, of the motion.</summary>
    public bool TellsVelocity { get; init; }

    public bool TellsAcceleration { get; init; }

    /// <summary>Time before which frames are not scored, s.</summary>
    public double WarmUp { get; init; } = 1.2;

    /// <summary>Number of runs with random phases of sampling and frames. The phase alone changes a ratio by a tenth.</summary>
    public int Phases { get; init; } = 8;

    public int Seed { get; init; } = 1;
}
