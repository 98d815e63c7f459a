namespace Nowpose.Cli.Replay;

/// <summary>Runs samples and frames in virtual time: decides which samples have arrived by each frame, and which frames are scored.</summary>
/// <remarks>All times are in seconds since the start of the recording. Absolute times would reduce the precision of the fit.</remarks>
sealed class ReplayLoop
{
    /// <summary>Maximum number of frames × axes: about 400 MB of errors. A larger number means a wrong time unit rather than a long motion.</summary>
    const double MaxValues = 5e7;

    /// <summary>Maximum number of samples. Each sample takes computing time, even if few frames use it.</summary>
    const double MaxSamples = 5e7;

    /// <summary>Interval of the reports, frames. A frame takes some microseconds.</summary>
    const int FramesPerReport = 1000;

    readonly string _path;
    readonly double _duration;
    readonly int _axes;
    readonly ReplaySettings _settings;

    /// <param name="path">Path of the recording, for error messages.</param>
    /// <param name="duration">Duration of the recording, s.</param>
    /// <param name="axes">Number of scored values per frame.</param>
    /// <exception cref="InputException">The recording is too long to replay.</exception>
    public ReplayLoop(string path, double duration, int axes, ReplaySettings settings)
    {
        _path = path;
        _duration = duration;
        _axes = axes;
        _settings = settings;
        RequireMaxLength();
    }

    /// <summary>Number of frames of all passes over the recording.</summary>
    public int Frames => FramesPerPass * _settings.Phases;

    int FramesPerPass => (int)(_duration * _settings.FrameRateHz) + 1;

    /// <summary>Runs all passes to the end of the recording, or until it is cancelled.</summary>
    /// <param name="start">Called before each pass, to discard what was learned.</param>
    /// <param name="positionsAt">Returns the sample values at the given time in s, as a new array.</param>
    /// <param name="take">Called for each sample when it has arrived.</param>
    /// <param name="score">Called for each scored frame with its time.</param>
    /// <param name="report">Receives the number of finished frames from time to time; null if it is not needed.</param>
    /// <returns>Number of scored frames; at least 1.</returns>
    /// <exception cref="InputException">No frame could be scored.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled before a frame was scored.</exception>
    public int Run(
        Action start, Func<double, double[]> positionsAt, Action<SampleFlow.Sample> take, Action<double> score, Action<int> report,
        CancellationToken cancellation)
    {
        var frames = 0;
        for (var phase = 0; phase < _settings.Phases && !cancellation.IsCancellationRequested; phase++)
        {
            start();
            var (flow, passed) = (new SampleFlow(_duration, positionsAt, _settings), phase * FramesPerPass);
            frames += RunPass(phase, flow, take, score, i => report?.Invoke(passed + i), cancellation);
        }
        if (frames > 0) return frames;
        cancellation.ThrowIfCancellationRequested();
        throw NothingScored();
    }

    int RunPass(
        int phase, SampleFlow flow, Action<SampleFlow.Sample> take, Action<double> score, Action<int> report, CancellationToken cancellation)
    {
        var delay = phase / (_settings.Phases * _settings.FrameRateHz);
        var (end, frames, anyArrived) = (Ticks.Of(_duration), 0, false);
        for (var i = 0; Ticks.Of(i / _settings.FrameRateHz + delay) <= end && !cancellation.IsCancellationRequested; i++)
        {
            if (i % FramesPerReport == 0) report(i);
            var time = i / _settings.FrameRateHz + delay;
            while (flow.TryTake(time, out var sample))
            {
                anyArrived = true;
                take(sample);
            }
            if (!anyArrived || !flow.ScoringHasStarted(time)) continue;
            score(time);
            frames++;
        }
        return frames;
    }

    /// <summary>Gets the maximum number of passes over a recording; 0 if it is too long to replay.</summary>
    /// <inheritdoc cref="ReplayLoop(string, double, int, ReplaySettings)"/>
    public static int MaxPhases(double duration, int axes, ReplaySettings settings)
    {
        var (values, samples) = (duration * settings.FrameRateHz * axes, duration / settings.SamplingInterval);
        return (int)Math.Min(int.MaxValue, Math.Min(MaxValues / values, MaxSamples / samples));
    }

    void RequireMaxLength()
    {
        var max = MaxPhases(_duration, _axes, _settings);
        if (max == 0)
            throw new InputException(ReplayMessages.TooManyFrames(_path, _duration, _settings.FrameRateHz, _settings.SamplingInterval * 1e3));
        if (_settings.Phases > max) throw new InputException(ReplayMessages.TooManyPhases(_path, _settings.Phases, _duration, max));
    }

    InputException NothingScored()
    {
        var needed = 4 * _settings.SamplingInterval + _settings.Latency + _settings.Jitter + 1 / _settings.FrameRateHz;
        var cause = _duration < needed
            ? ReplayMessages.TooShort(_duration, needed)
            : ReplayMessages.AllLost(_settings.Loss);
        return new InputException($"{_path}: {cause}");
    }
}
