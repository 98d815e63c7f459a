namespace Nowpose.Studies;

/// <summary>Under which conditions a motion is predicted. The defaults are the paper's: T_s 50 ms, L 100 ms, 60 frames a second.</summary>
public sealed record StudySettings
{
    /// <summary>T_s, s.</summary>
    public double SamplingInterval { get; init; } = 0.050;

    /// <summary>L, s, from t_k to the arrival of the sample; frames are timed by when they are seen.</summary>
    public double Latency { get; init; } = 0.100;

    /// <summary>Added to the latency of each sample, uniform from 0 to this, s; none overtakes another.</summary>
    public double LatencySpread { get; init; }

    public double FrameRateHz { get; init; } = 60;

    /// <summary>ε_L, s, added to the time the predictor is asked for: positive when the latency is taken for too large.</summary>
    public double LatencyError { get; init; }

    /// <summary>Half-width of a uniform error of ε_L drawn anew for each frame, s.</summary>
    public double RandomLatencyError { get; init; }

    /// <summary>Half-width of the uniform error ε_t on each t_k told, s.</summary>
    public double StampError { get; init; }

    /// <summary>Half-width of the uniform deviation of the true sampling instants from the grid that the stamps tell, s.</summary>
    public double SamplingJitter { get; init; }

    /// <summary>The same of a source whose stamps tell the true instants, s.</summary>
    public double ToldJitter { get; init; }

    /// <summary>Median of a log-normal delay added to the latency of each sample, s; 0 for none. Samples overtake each other.</summary>
    public double DelayMedian { get; init; }

    /// <summary>Greatest delay added, s.</summary>
    public double DelayMaximum { get; init; } = 0.120;

    /// <summary>Probability that a sample never arrives.</summary>
    public double Loss { get; init; }

    /// <summary>Standard deviation of normal noise on the positions told, in the motion's unit.</summary>
    public double Noise { get; init; }

    /// <summary>Whether samples tell the velocity, and the acceleration, of the motion.</summary>
    public bool TellsVelocity { get; init; }

    public bool TellsAcceleration { get; init; }

    /// <summary>Frames before are not scored, s.</summary>
    public double WarmUp { get; init; } = 1.2;

    /// <summary>Runs with random phases of sampling and frames; the phase alone moves a ratio by a tenth.</summary>
    public int Phases { get; init; } = 8;

    public int Seed { get; init; } = 1;
}
