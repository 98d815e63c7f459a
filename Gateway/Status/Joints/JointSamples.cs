using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Joints;

/// <summary>The samples of one joint at the gateway: their rate, their age, and the time since the last sample with a new stamp.</summary>
sealed class JointSamples(TimeProvider time)
{
    // Weight of a new interval in the mean interval, so small that a few bursts over TCP hardly change the rate.
    const double Weight = 0.05;

    /// <summary>Age from which a sample says nothing about the present position. Headsets show a position of about a second at most.</summary>
    internal static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    // Arrival of the newest sample with another stamp than the sample before.
    long _last;
    ControlTime _stamp;
    TimeSpan _ageAtArrival;
    double _meanSeconds;

    /// <summary>The source of the newest sample; null if unknown.</summary>
    public HubSource Source { get; private set; }

    /// <summary>Namespace of the robot in the newest sample; empty if it has none.</summary>
    public string Robot { get; private set; }

    /// <summary>Arrival of the newest sample, a timestamp of the time provider.</summary>
    public long ArrivedAt { get; private set; }

    public DateTimeOffset LastUtc { get; private set; }

    public bool HasAny { get; private set; }

    /// <summary>Whether the source of the newest sample has ended normally.</summary>
    public bool HasLeft { get; private set; }

    /// <summary>Time since the newest sample with another stamp than the sample before arrived.</summary>
    public TimeSpan Silence => time.GetElapsedTime(_last);

    public bool IsFlowing => HasAny && Silence < JointBoard.StaleAfter && !IsOld;

    /// <summary>The reason why the samples that arrive are not current, as a sentence and as a word; null if none arrive or if they are current.</summary>
    public (string Reason, string Word)? StampFault
    {
        get
        {
            if (!HasAny || IsFlowing || time.GetElapsedTime(ArrivedAt) >= JointBoard.StaleAfter) return null;
            return IsOld ? (JointReasons.StampsOld, JointFaultReasons.StampOld) : (JointReasons.StampsStopped, JointFaultReasons.StampNotNewer);
        }
    }

    bool IsOld => _ageAtArrival > MaxAge;

    /// <summary>Control time minus the newest sample's stamp; null before the first sample.</summary>
    public TimeSpan? Age => HasAny ? _ageAtArrival + Silence : null;

    public double RateHz => IsFlowing && _meanSeconds > 0 ? 1 / Math.Max(_meanSeconds, Silence.TotalSeconds) : 0;

    /// <summary>Records that the source ended normally.</summary>
    public void Leave() => HasLeft = true;

    /// <summary>Adds a sample that has just arrived.</summary>
    /// <param name="source">Source of the sample.</param>
    /// <param name="age">Control time at the arrival minus the sample's stamp.</param>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    public void Add(HubSource source, ControlTime stamp, TimeSpan age, string robot = "")
    {
        var now = ArrivedAt = time.GetTimestamp();
        if (HasAny && source == Source && stamp == _stamp)
        {
            HasLeft = false;
            return;
        }

        var interval = time.GetElapsedTime(_last, now).TotalSeconds;
        // Restarts the mean after a pause, which is not a sampling interval.
        if (!IsFlowing) _meanSeconds = 0;
        else _meanSeconds = _meanSeconds == 0 ? interval : _meanSeconds + Weight * (interval - _meanSeconds);
        (HasAny, HasLeft) = (true, false);
        (Source, Robot, _stamp, _last, _ageAtArrival, LastUtc) = (source, robot, stamp, now, age, time.GetUtcNow());
    }
}
