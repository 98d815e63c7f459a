using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Kinematics;
using Nowpose.Prediction;

namespace Nowpose.Cli.Replay;

/// <summary>
/// Replays the recording of a rigid body with a predictor in virtual time. Sampling, arrival and frames are the same as for joints.
/// </summary>
public sealed class BodyReplay
{
    const double MmPerMetre = 1000, DegreesPerRadian = 180 / Math.PI;

    /// <summary>Number of errors per frame: position and rotation.</summary>
    const int Errors = 2;

    readonly string _path;
    readonly ReplaySettings _settings;
    readonly ReplayLoop _loop;
    readonly BodyTruth _truth;
    readonly Func<BodyPredictor> _newPredictor;
    readonly ErrorCollector _position = new();
    readonly ErrorCollector _rotation = new();
    readonly PassErrors _passes = new();
    BodyPredictor _predictor;
    double _displayed;
    long _frame;

    /// <param name="path">Path of the recording, for results and error messages.</param>
    /// <param name="recording">Recording of a rigid body.</param>
    /// <exception cref="InputException">The predictor is unknown, or the recording is too long to replay.</exception>
    public BodyReplay(string path, MotionRecording recording, ReplaySettings settings) : this(path, recording, settings, null) { }

    /// <inheritdoc cref="BodyReplay(string, MotionRecording, ReplaySettings)"/>
    /// <param name="newPredictor">Creates the predictor. If null, the predictor of the settings is used.</param>
    internal BodyReplay(string path, MotionRecording recording, ReplaySettings settings, Func<BodyPredictor> newPredictor)
    {
        _path = path;
        _settings = settings;
        _truth = new BodyTruth(recording);
        _loop = new ReplayLoop(path, recording.Duration, Errors, settings);
        _newPredictor = newPredictor ?? (() => new BodyPredictor(settings.Predictor, PredictionLimits.Unlimited, settings.Blend ?? 0));
    }

    /// <summary>The axes of <see cref="Scored"/>. The angle is that from the true rotation.</summary>
    internal static IReadOnlyList<(string Name, string Unit)> Axes { get; } = [("x", "m"), ("y", "m"), ("z", "m"), ("angle", "deg")];

    /// <inheritdoc cref="ReplayLoop.Frames"/>
    public int Frames => _loop.Frames;

    /// <inheritdoc cref="ReplayRun.Scored"/>
    internal Action<ScoredValue> Scored { get; init; }

    /// <summary>Runs once to the end of the recording. After a cancellation, returns the results so far.</summary>
    /// <param name="report">Receives the number of finished frames from time to time; null if it is not needed.</param>
    /// <exception cref="InputException">No frame could be scored, or the errors overflow.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled before a frame was scored.</exception>
    public BodyReplayResult Run(Action<int> report = null, CancellationToken cancellation = default)
    {
        var frames = _loop.Run(Start, PoseAt, Take, Score, report, cancellation);
        var result = new BodyReplayResult(
            _path, _settings.Predictor, frames, _position.Result(MmPerMetre), _rotation.Result(DegreesPerRadian))
        { Passes = _passes.Result(MmPerMetre) };
        if (!double.IsFinite(result.Position.Rms + result.Position.RmsHold))
            throw new InputException(ReplayMessages.BodyTooLarge(_path));
        return result;
    }

    void Start()
    {
        _predictor = _newPredictor();
        _displayed = double.NaN;
        _passes.Start();
    }

    double[] PoseAt(double time)
    {
        var (x, y, z, rotation) = _truth.At(time);
        return [x, y, z, rotation.X, rotation.Y, rotation.Z, rotation.W];
    }

    void Take(SampleFlow.Sample sample)
    {
        var p = sample.Positions;
        UnitQuaternion.TryNormalise(p[3], p[4], p[5], p[6], out var rotation);
        _predictor.Add(new PoseSample(sample.Stamp, new Vector3D(p[0], p[1], p[2]), rotation, sample.Time), _displayed);
    }

    void Score(double time)
    {
        var (x, y, z, rotation) = _truth.At(time);
        var truth = rotation.At(x, y, z);
        _displayed = time + _settings.LatencyError;
        var (hold, predicted) = (_predictor.Hold, _predictor.At(_displayed));
        var (holdAngle, angle) = (hold.AngleTo(truth), predicted.AngleTo(truth));
        var (holdDistance, distance) = (hold.DistanceTo(truth), predicted.DistanceTo(truth));
        _position.Add(holdDistance, distance);
        _rotation.Add(holdAngle, angle);
        _passes.Add(holdDistance * holdDistance, distance * distance);
        if (Scored == null) return;
        foreach (var value in ValuesOf(_frame++, Ticks.Of(time), truth, hold, predicted)) Scored(value with { Pass = _passes.Count });
    }

    /// <summary>Gets one value for each of <see cref="Axes"/>.</summary>
    internal static ScoredValue[] ValuesOf(long frame, long ticks, in RigidTransform truth, in RigidTransform hold, in RigidTransform predicted)
    {
        ScoredValue Of(int axis, double trueValue, double held, double forecast) => new(frame, ticks, axis, trueValue, held, forecast, double.NaN);
        return
        [
            Of(0, truth.X, hold.X, predicted.X), Of(1, truth.Y, hold.Y, predicted.Y), Of(2, truth.Z, hold.Z, predicted.Z),
            Of(3, 0, hold.AngleTo(truth) * DegreesPerRadian, predicted.AngleTo(truth) * DegreesPerRadian),
        ];
    }
}
