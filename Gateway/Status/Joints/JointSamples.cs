using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Joints;

/// <summary>The samples of one joint at the gateway: their rate, their age, and the time since the last sample.</summary>
sealed class JointSamples(TimeProvider time)
{
    // Weight of a new interval in the mean interval, so small that a few bursts over TCP hardly change the rate.
    const double Weight = 0.05;

    long _last;
    TimeSpan _ageAtArrival;
    double _meanSeconds;

    /// <summary>The source of the newest sample; null if unknown.</summary>
    public HubSource Source { get; private set; }

    public DateTimeOffset LastUtc { get; private set; }

    public bool HasAny { get; private set; }

    /// <summary>Whether the source of the newest sample has ended normally.</summary>
    public bool HasLeft { get; private set; }

    /// <summary>Time since the newest sample arrived.</summary>
    public TimeSpan Silence => time.GetElapsedTime(_last);

    public bool IsFlowing => HasAny && Silence < JointBoard.StaleAfter;

    /// <summary>Control time minus the newest sample's stamp; null before the first sample.</summary>
    public TimeSpan? Age => HasAny ? _ageAtArrival + Silence : null;

    public double RateHz => IsFlowing && _meanSeconds > 0 ? 1 / Math.Max(_meanSeconds, Silence.TotalSeconds) : 0;

    /// <summary>Records that the source ended normally.</summary>
    public void Leave() => HasLeft = true;

    /// <summary>Adds a sample that has just arrived.</summary>
    /// <param name="source">Source of the sample.</param>
    /// <param name="age">Control time at the arrival minus the sample's stamp.</param>
    public void Add(HubSource source, TimeSpan age)
    {
        var now = time.GetTimestamp();
        var interval = time.GetElapsedTime(_last, now).TotalSeconds;
        // Restarts the mean after a pause, which is not a sampling interval.
        if (!IsFlowing) _meanSeconds = 0;
        else _meanSeconds = _meanSeconds == 0 ? interval : _meanSeconds + Weight * (interval - _meanSeconds);
        (HasAny, HasLeft) = (true, false);
        (Source, _last, _ageAtArrival, LastUtc) = (source, now, age, time.GetUtcNow());
    }
}
