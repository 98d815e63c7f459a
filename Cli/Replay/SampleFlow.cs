namespace Nowpose.Cli.Replay;

/// <summary>Samples a recording every T_s and returns the samples in the order in which they arrive.</summary>
/// <remarks>Times are in seconds since the start of the recording.</remarks>
sealed class SampleFlow
{
    /// <summary>Scoring starts when the sample with this index arrives. The longest history, h = 4, then has enough samples.</summary>
    const int FirstScoredSample = 4;

    readonly Func<double, double[]> _positionsAt;
    readonly ReplaySettings _settings;
    readonly PriorityQueue<Sample, (long Arrival, long Index)> _underWay = new();
    readonly RandomStream _jitter;
    readonly RandomStream _loss;
    readonly RandomStream _stamp;
    readonly long _end;
    long _next;
    long _scoringStart = long.MaxValue;

    /// <param name="duration">Duration of the recording, s.</param>
    /// <param name="positionsAt">Returns the sample values at a given time since the start of the recording, as a new array.</param>
    public SampleFlow(double duration, Func<double, double[]> positionsAt, ReplaySettings settings)
    {
        _positionsAt = positionsAt;
        _settings = settings;
        _end = Ticks.Of(duration);
        _jitter = new RandomStream(settings.Seed, 1);
        _loss = new RandomStream(settings.Seed, 2);
        _stamp = new RandomStream(settings.Seed, 3);
    }

    /// <summary>A sample of the recording.</summary>
    /// <param name="Time">True t_k, s.</param>
    /// <param name="Stamp">Time stamp that the predictor receives, s: t_k with the error ε_t.</param>
    /// <param name="Positions">Values of the recording's columns.</param>
    public readonly record struct Sample(double Time, double Stamp, double[] Positions);

    /// <summary>Gets the next sample that has arrived by the time of a frame. Frame times must not decrease.</summary>
    public bool TryTake(double frameTime, out Sample sample)
    {
        var frame = Ticks.Of(frameTime);
        while (EarliestArrival(_next) <= frame && IsInside(_next)) Send(_next++);
        sample = default;
        return _underWay.TryPeek(out _, out var due) && due.Arrival <= frame && _underWay.TryDequeue(out sample, out _);
    }

    /// <summary>Gets whether scoring has started: sample 4 has arrived, or would have arrived if it had not been lost.</summary>
    public bool ScoringHasStarted(double frameTime) => Ticks.Of(frameTime) >= _scoringStart;

    double TimeOf(long index) => index * _settings.SamplingInterval;

    bool IsInside(long index) => Ticks.Of(TimeOf(index)) <= _end;

    long EarliestArrival(long index) => Ticks.Of(TimeOf(index) + _settings.Latency);

    void Send(long index)
    {
        // Every sample draws a number from every stream, so that changing one option does not change the random numbers of another.
        var time = TimeOf(index);
        var stamp = time + _settings.StampError * (2 * _stamp.Next() - 1);
        var arrival = Ticks.Of(time + _settings.Latency + _settings.Jitter * _jitter.Next());
        var lost = _loss.Next() < _settings.Loss;
        if (index == FirstScoredSample) _scoringStart = arrival;
        if (!lost) _underWay.Enqueue(new Sample(time, stamp, _positionsAt(time)), (arrival, index));
    }
}
