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
    readonly Func<JointPredictor> _newPredictor;
    readonly JointPredictor[] _predictors;
    readonly PassErrors _passes = new();
    readonly double[] _truth;
    double _displayed;
    long _frame;

    /// <param name="path">Path of the recording, for results and error messages.</param>
    /// <exception cref="InputException">The predictor is unknown, or the recording is too long to replay.</exception>
    /// <param name="newPredictor">Creates the predictor of a joint. If null, the predictor of the settings is used.</param>
    public ReplayRun(string path, MotionRecording recording, ReplaySettings settings, Func<JointPredictor> newPredictor = null)
    {
        _path = path;
        _recording = recording;
        _settings = settings;
        _loop = new ReplayLoop(path, recording.Duration, recording.Names.Count, settings);
        _newPredictor = newPredictor ?? (() => Predictors.Create(settings.Predictor, PredictionLimits.Unlimited, settings.Blend ?? 0));
        _predictors = new JointPredictor[recording.Names.Count];
        _truth = new double[recording.Names.Count];
    }

    /// <inheritdoc cref="ReplayLoop.Frames"/>
    public int Frames => _loop.Frames;

    /// <summary>Called for each axis of each scored frame.</summary>
    internal Action<ScoredValue> Scored { get; init; }

    /// <summary>Gets the names of the axes, and their units, which a motion does not state.</summary>
    internal static IReadOnlyList<(string Name, string Unit)> AxesOf(MotionRecording recording) =>
        [.. recording.Names.Select(name => (name, (string)null))];

    /// <summary>Runs all passes to the end of the recording. After a cancellation, returns the results so far.</summary>
    /// <param name="report">Receives the number of finished frames from time to time; null if it is not needed.</param>
    /// <exception cref="InputException">No frame could be scored, or the errors overflow.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled before a frame was scored.</exception>
    public ReplayResult Run(Action<int> report = null, CancellationToken cancellation = default)
    {
        var errors = new ReplayErrors(AxesOf(_recording));
        Score(errors.Add + Scored, report, cancellation);
        return errors.Result(_path, _settings.Predictor) with { Passes = _passes.Result() };
    }

    /// <summary>Runs all passes without collecting the errors of the axes.</summary>
    /// <param name="scored">Called for each axis of each scored frame.</param>
    /// <inheritdoc cref="Run"/>
    internal void Score(Action<ScoredValue> scored, Action<int> report = null, CancellationToken cancellation = default) =>
        _loop.Run(Start, PositionsAt, Take, time => Score(time, scored), report, cancellation);

    void Start()
    {
        for (var joint = 0; joint < _predictors.Length; joint++) _predictors[joint] = _newPredictor();
        _displayed = double.NaN;
        _passes.Start();
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

    void Score(double time, Action<ScoredValue> scored)
    {
        _recording.At(time, _truth);
        _displayed = time + _settings.LatencyError;
        var (holdSquare, square) = (0.0, 0.0);
        for (var joint = 0; joint < _truth.Length; joint++)
        {
            var predictor = _predictors[joint];
            var value = new ScoredValue(
                _frame, Ticks.Of(time), joint, _truth[joint], predictor.Hold, predictor.At(_displayed).Position, predictor.DeviationAt(_displayed))
            { Pass = _passes.Count };
            scored(value);
            holdSquare += value.HoldError * value.HoldError;
            square += value.Error * value.Error;
        }
        _passes.Add(holdSquare, square);
        _frame++;
    }
}
