using Nowpose.Prediction;
using Nowpose.Session;

namespace Nowpose.Cli.Replay;

/// <summary>
/// Replays a recorded session in virtual time, with its own samples, plans and frames and one predictor per joint.
/// </summary>
/// <remarks>
/// Events are processed in the order of the file, which is the order in which the headset processed them. Limits, horizon cap and maximum gap come
/// from the recording. With the predictor of the recording, the replay therefore reproduces the displayed values. Frames in which the newest sample of a
/// joint is older than the maximum gap are not scored for this joint. Otherwise, after a restart of a source with its clock behind, a frame would be
/// compared with later samples that have the same time stamps as its own.
/// </remarks>
sealed class SessionReplay
{
    /// <summary>
    /// Number of samples after which a joint is scored: the longest history in <see cref="Predictors.Names"/>, 4, plus the newest sample.
    /// </summary>
    const int SamplesBeforeScoring = 5;

    readonly string _path;
    readonly RecordedSession _session;
    readonly SessionTruth _truth;
    readonly ReplaySettings _settings;
    readonly RandomStream _stampErrors;
    readonly bool _followsPlans;
    readonly JointPredictor[] _joints;
    readonly JointRun[] _runs;
    int _timeLine;
    ControlTime? _epoch;
    double _displayed = double.NaN;

    /// <param name="path">Path of the session file, for the result and for error messages.</param>
    /// <param name="truth">True joint positions of the session.</param>
    /// <param name="settings">Predictor, blend, errors and seed. Values that the recording defines, such as the latency, are ignored.</param>
    public SessionReplay(string path, RecordedSession session, SessionTruth truth, ReplaySettings settings)
    {
        _path = path;
        _session = session;
        _truth = truth;
        _settings = settings;
        _stampErrors = new RandomStream(settings.Seed, 3);
        var prediction = PredictionOf(session.Header.Prediction, settings);
        _followsPlans = prediction.FollowsPlans;
        _joints = [.. session.Header.Joints.Select(joint => prediction.Create(joint.BoundedBy(prediction)))];
        _runs = new JointRun[_joints.Length];
    }

    /// <summary>Gets the prediction settings of a recording, with the predictor and blend of the replay.</summary>
    internal static PredictionSettings PredictionOf(PredictionSettings own, ReplaySettings settings) => new(
        settings.Predictor, own.HorizonCap.TotalMilliseconds, own.MaximumGap.TotalMilliseconds,
        settings.Blend * 1000 ?? own.Blend.TotalMilliseconds, own.FollowPlan && settings.FollowPlan, own.SpeedShare,
        own.AccelerationLimit, own.JerkLimit);

    /// <summary>Called for each frame with the frame, one predicted position per joint, and the kinds of these predictions.</summary>
    public Action<RecordedSession.Event, double[], PredictionKind[]> Predicted { get; init; }

    /// <summary>Gets the names of the joints, and their units.</summary>
    public static IReadOnlyList<(string Name, string Unit)> AxesOf(RecordedSession session) =>
        [.. session.Header.Joints.Select(joint => (joint.Name, joint.Unit))];

    /// <summary>Called for each joint of each scored frame. The number of the frame is its index among all frames.</summary>
    public Action<ScoredValue> Scored { get; init; }

    /// <summary>Whether at least one frame has been scored.</summary>
    public bool HasScored { get; private set; }

    /// <param name="report">Receives the number of finished events; null if it is not needed.</param>
    /// <exception cref="InputException">No frame could be scored.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled before a frame was scored.</exception>
    public ReplayResult Run(Action<int> report = null, CancellationToken cancellation = default)
    {
        var errors = new ReplayErrors(AxesOf(_session));
        Score(errors.Add + Scored, report, cancellation);
        return errors.Result(_path, _settings.Predictor);
    }

    /// <summary>Replays the session without collecting the errors of the joints.</summary>
    /// <param name="scored">Called for each joint of each scored frame.</param>
    /// <inheritdoc cref="Run"/>
    public void Score(Action<ScoredValue> scored, Action<int> report = null, CancellationToken cancellation = default)
    {
        for (var i = 0; i < _session.Events.Count && !cancellation.IsCancellationRequested; i++)
        {
            report?.Invoke(i);
            Play(_session.Events[i], scored);
        }
        if (HasScored) return;
        cancellation.ThrowIfCancellationRequested();
        throw new InputException($"{_path}: {NothingScored}");
    }

    internal static string NothingScored => ReplayMessages.NothingScored(SamplesBeforeScoring);

    void Play(in RecordedSession.Event next, Action<ScoredValue> scored)
    {
        if (next.TimeLine != _timeLine || _epoch == null) StartTimeLine(next);
        if (next.Kind == RecordedSession.EventKind.Sample) Take(next);
        else if (next.Kind == RecordedSession.EventKind.Plan) Follow(next);
        else if (next.Kind == RecordedSession.EventKind.Frame && next.IsTimed) Show(next, scored);
    }

    // Discards all samples if the clock has stepped since the last event, because earlier times are then not comparable with the new ones.
    void StartTimeLine(in RecordedSession.Event next)
    {
        if (next.TimeLine != _timeLine)
        {
            foreach (var joint in _joints) joint.Reset();
            Array.Clear(_runs);
            _epoch = null;
            _displayed = double.NaN;
        }
        _timeLine = next.TimeLine;
        if (next.Kind == RecordedSession.EventKind.Sample || IsFollowed(next)) _epoch ??= next.At;
    }

    void Take(in RecordedSession.Event sample)
    {
        var time = Seconds(sample.At);
        var stamp = time + _settings.StampError * (2 * _stampErrors.Next() - 1);
        foreach (var value in _session.ValuesOf(sample))
        {
            _joints[value.Joint].Add(new JointSample(stamp, value.Position, time, value.Velocity, value.Acceleration), _displayed);
            ref var run = ref _runs[value.Joint];
            var truth = _truth.Of(value.Joint, sample);
            if (truth != run.Truth) run = new JointRun { Truth = truth, Newest = sample.At };
            if (sample.At > run.Newest) run.Newest = sample.At;
            run.Samples++;
        }
    }

    bool IsFollowed(in RecordedSession.Event next) => _followsPlans && next.Kind == RecordedSession.EventKind.Plan;

    void Follow(in RecordedSession.Event next)
    {
        if (!IsFollowed(next)) return;
        var plan = _session.PlanOf(next);
        for (var i = 0; i < plan.Count; i++) _joints[plan.JointAt(i)].Follow(plan.PathAt(i), Seconds(next.At), _displayed);
    }

    void Show(in RecordedSession.Event frame, Action<ScoredValue> scored)
    {
        _displayed = Seconds(frame.At) + _settings.LatencyError;
        var (positions, kinds) = Predicted == null ? default : (new double[_joints.Length], new PredictionKind[_joints.Length]);
        for (var joint = 0; joint < _joints.Length; joint++)
        {
            var prediction = _joints[joint].At(_displayed);
            if (Predicted != null) (positions[joint], kinds[joint]) = (prediction.Position, prediction.Kind);
            var known = _runs[joint].Truth;
            if (!_runs[joint].IsScoredAt(frame.At, _session.Header.Prediction.MaximumGap) || !known.TryAt(frame.At, out var truth)) continue;
            // The standard deviation describes the forecast. A plan replaces the forecast, so there is none.
            var deviation = prediction.Kind == PredictionKind.Planned ? double.NaN : _joints[joint].DeviationAt(_displayed);
            double Near(double position) => truth + known.Difference(position, truth);
            var value = new ScoredValue(
                frame.First, frame.At.SinceEpoch.Ticks, joint, truth, Near(_joints[joint].Hold), Near(prediction.Position), deviation);
            HasScored = true;
            scored(value);
        }
        Predicted?.Invoke(frame, positions, kinds);
    }

    double Seconds(ControlTime t) => (t - _epoch.GetValueOrDefault()).Ticks / (double)TimeSpan.TicksPerSecond;

    /// <summary>The samples of a joint since the last restart of its source.</summary>
    struct JointRun
    {
        public RecordedTruth Truth;
        public ControlTime Newest;
        public int Samples;

        public readonly bool IsScoredAt(ControlTime at, TimeSpan maximumGap) => Samples >= SamplesBeforeScoring && at - Newest <= maximumGap;
    }
}
