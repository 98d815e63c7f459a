using Nowpose.Gateway.MotionRecordings;
using Nowpose.Prediction;

namespace Nowpose.Cli.Replay;

/// <summary>Plays a recording in virtual time to one predictor per joint, frame by frame, and compares the result with the file.</summary>
/// <remarks>All times are seconds since the recording's start. Dates in seconds would reduce the precision of the fit.</remarks>
public sealed class ReplayRun
{
    /// <summary>Maximum of frames × axes: about 400 MB of errors. More indicates a wrong time unit rather than a long motion.</summary>
    const double MaxValues = 5e7;

    /// <summary>Maximum number of samples. They take time even if few frames use them.</summary>
    const double MaxSamples = 5e7;

    readonly string _path;
    readonly MotionRecording _recording;
    readonly ReplaySettings _settings;
    readonly SampleFlow _flow;
    readonly JointPredictor[] _predictors;
    readonly AxisError[] _errors;
    readonly double[] _truth;
    int _frames;
    bool _anyArrived;
    double _displayed = double.NaN;

    /// <param name="path">Path for results and messages.</param>
    /// <exception cref="InputException">The predictor is unknown, or the recording is too long to replay.</exception>
    /// <param name="newPredictor">Creates a joint's predictor; null for the predictor of the settings.</param>
    public ReplayRun(string path, MotionRecording recording, ReplaySettings settings, Func<JointPredictor> newPredictor = null)
    {
        _path = path;
        _recording = recording;
        _settings = settings;
        _flow = new SampleFlow(recording, settings);
        newPredictor ??= () => Predictors.Create(settings.Predictor, PredictionLimits.Unlimited, settings.Blend ?? 0);
        _predictors = [.. recording.Names.Select(_ => newPredictor())];
        _errors = [.. recording.Names.Select(_ => new AxisError())];
        _truth = new double[recording.Names.Count];
        RequireBearableLength();
    }

    /// <summary>Runs once to the recording's end. When cancelled, it returns the results so far.</summary>
    /// <exception cref="InputException">No frame could be scored, or the errors overflow.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before anything was measured.</exception>
    public ReplayResult Run(CancellationToken cancellation = default)
    {
        var end = Ticks.Of(_recording.Duration);
        for (long i = 0; Ticks.Of(i / _settings.FrameRateHz) <= end && !cancellation.IsCancellationRequested; i++)
            Frame(i / _settings.FrameRateHz);
        if (_frames == 0)
        {
            cancellation.ThrowIfCancellationRequested();
            throw NothingScored();
        }
        var axes = _errors.Zip(_recording.Names, (error, name) => error.Summary(name));
        var result = new ReplayResult(_path, _settings.Predictor, _frames, [.. axes]);
        if (!double.IsFinite(result.Rms + result.RmsHold))
            throw new InputException($"{_path}: the errors are too large to compute; the positions must be in rad or m");
        return result;
    }

    void Frame(double time)
    {
        while (_flow.TryTake(time, out var sample)) Take(sample);
        if (_anyArrived && _flow.ScoringHasStarted(time)) Score(time);
    }

    void Take(in SampleFlow.Sample sample)
    {
        _anyArrived = true;
        for (var joint = 0; joint < _predictors.Length; joint++)
            _predictors[joint].Add(new JointSample(sample.Stamp, sample.Positions[joint], sample.Time), _displayed);
    }

    void Score(double time)
    {
        _recording.At(time, _truth);
        _displayed = time + _settings.LatencyError;
        for (var joint = 0; joint < _truth.Length; joint++)
        {
            var predictor = _predictors[joint];
            _errors[joint].Add(
                predictor.Hold - _truth[joint], predictor.At(_displayed).Position - _truth[joint], predictor.DeviationAt(_displayed));
        }
        _frames++;
    }

    void RequireBearableLength()
    {
        var values = _recording.Duration * _settings.FrameRateHz * _recording.Names.Count;
        var samples = _recording.Duration / _settings.SamplingInterval;
        if (values > MaxValues || samples > MaxSamples)
            throw new InputException($"{_path}: " + FormattableString.Invariant(
                $"{_recording.Duration:G6} s are too long to replay at {_settings.FrameRateHz} frames per second ")
                + FormattableString.Invariant($"and a sample every {_settings.SamplingInterval * 1e3:G6} ms; is the time column in seconds?"));
    }

    InputException NothingScored()
    {
        var needed = 4 * _settings.SamplingInterval + _settings.Latency + _settings.Jitter + 1 / _settings.FrameRateHz;
        var cause = _recording.Duration < needed
            ? FormattableString.Invariant($"{_recording.Duration:G6} s are too short: a frame is evaluated only after sample 4 has arrived, ")
                + FormattableString.Invariant($"which takes up to {needed:G6} s")
            : FormattableString.Invariant($"--loss {_settings.Loss}: no sample arrived, so no frame could be scored");
        return new InputException($"{_path}: {cause}");
    }
}
