using Nowpose.Cli.Messages;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Prediction;

namespace Nowpose.Cli.Replay;

/// <summary>Replays a recorded motion in virtual time with one predictor per joint, and compares each frame with the recording.</summary>
/// <remarks>All times are in seconds since the start of the recording. Absolute times would reduce the precision of the fit.</remarks>
public sealed class ReplayRun
{
    readonly string _path;
    readonly MotionRecording _recording;
    readonly ReplaySettings _settings;
    readonly ReplayLoop _loop;
    readonly JointPredictor[] _predictors;
    readonly AxisError[] _errors;
    readonly double[] _truth;
    double _displayed = double.NaN;

    /// <param name="path">Path of the recording, for results and error messages.</param>
    /// <exception cref="InputException">The predictor is unknown, or the recording is too long to replay.</exception>
    /// <param name="newPredictor">Creates the predictor of a joint. If null, the predictor of the settings is used.</param>
    public ReplayRun(string path, MotionRecording recording, ReplaySettings settings, Func<JointPredictor> newPredictor = null)
    {
        _path = path;
        _recording = recording;
        _settings = settings;
        newPredictor ??= () => Predictors.Create(settings.Predictor, PredictionLimits.Unlimited, settings.Blend ?? 0);
        _predictors = [.. recording.Names.Select(_ => newPredictor())];
        _errors = [.. recording.Names.Select(_ => new AxisError())];
        _truth = new double[recording.Names.Count];
        _loop = new ReplayLoop(path, recording.Duration, recording.Names.Count, settings);
    }

    /// <summary>Number of frames of the whole recording.</summary>
    public int Frames => _loop.Frames;

    /// <summary>Runs once to the end of the recording. After a cancellation, returns the results so far.</summary>
    /// <param name="report">Receives the number of finished frames from time to time; null if it is not needed.</param>
    /// <exception cref="InputException">No frame could be scored, or the errors overflow.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled before a frame was scored.</exception>
    public ReplayResult Run(Action<int> report = null, CancellationToken cancellation = default)
    {
        var frames = _loop.Run(PositionsAt, Take, Score, report, cancellation);
        var axes = _errors.Zip(_recording.Names, (error, name) => error.Summary(name));
        var result = new ReplayResult(_path, _settings.Predictor, frames, [.. axes]);
        if (!double.IsFinite(result.Rms + result.RmsHold))
            throw new InputException(ReplayMessages.TooLarge(_path));
        return result;
    }

    double[] PositionsAt(double time)
    {
        var positions = new double[_recording.Names.Count];
        _recording.At(time, positions);
        return positions;
    }

    void Take(SampleFlow.Sample sample)
    {
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
    }
}
