using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction.Samples;

namespace Nowpose.Cli.Replay;

/// <summary>Replays the tracked frames of a recorded session in virtual time, with one predictor per frame.</summary>
/// <remarks>
/// Events are processed in the order of the file, as for joints. The truth is interpolated between the last sample before the display time and the
/// first sample after it. It is unknown across a change of the parent, a restart of the source, and gaps. Displayed frames in which an object does not
/// move, or whose newest sample is too old to be shown as current, are not scored.
/// </remarks>
sealed class SessionBodies
{
    /// <summary>Number of samples after which a tracked frame is scored; the same as for joints.</summary>
    const int SamplesBeforeScoring = 5;

    readonly RecordedSession _session;
    readonly ReplaySettings _settings;
    readonly RandomStream _stampErrors;
    readonly SortedDictionary<string, Body> _bodies = new(StringComparer.Ordinal);

    public SessionBodies(RecordedSession session, ReplaySettings settings)
    {
        _session = session;
        _settings = settings;
        _stampErrors = new RandomStream(settings.Seed, 5);
        var prediction = SessionReplay.PredictionOf(session.Header.Prediction, settings);
        var newPredictor = prediction.BodiesOfACell();
        foreach (var pose in session.Events)
        {
            if (pose.Kind != RecordedSession.EventKind.Pose) continue;
            var line = session.PoseOf(pose);
            if (!_bodies.TryGetValue(line.Frame, out var body)) _bodies.Add(line.Frame, body = new Body(newPredictor, prediction.MaximumGap));
            body.AddTruth(pose.TimeLine, line.Parent, pose.At, line.Position, line.Rotation);
        }
    }

    /// <summary>Gets the result of each object that moves. After a cancellation, returns the results so far.</summary>
    /// <param name="report">Receives the number of finished events; null if it is not needed.</param>
    public IReadOnlyList<BodyReplayResult> Run(Action<int> report = null, CancellationToken cancellation = default)
    {
        RecordedSession.Event frame = default;
        for (var i = 0; i < _session.Events.Count && !cancellation.IsCancellationRequested; i++)
        {
            report?.Invoke(i);
            var next = _session.Events[i];
            if (next.Kind == RecordedSession.EventKind.Frame) frame = next;
            if (next.Kind == RecordedSession.EventKind.Pose) _bodies[_session.PoseOf(next).Frame].Take(_settings.StampError * (2 * _stampErrors.Next() - 1));
            else if (next.Kind == RecordedSession.EventKind.Frame && next.IsTimed)
                foreach (var body in _bodies.Values) body.Show(next.TimeLine, next.At, _settings.LatencyError);
            // The line of the frame is missing if the recording could not keep up.
            else if (next.Kind == RecordedSession.EventKind.Object && frame.IsTimed && (frame.At, frame.TimeLine) == (next.At, next.TimeLine))
            {
                var (name, pose) = _session.ObjectOf(next);
                if (_bodies.TryGetValue(name, out var body)) body.AddDisplayed(pose);
            }
        }
        return [.. _bodies.Where(body => body.Value.Frames > 0).Select(body => body.Value.Result(body.Key, _settings.Predictor))];
    }

    /// <summary>Consecutive poses of a tracked frame with the same parent, without a step of the clock or a restart of the source between them.</summary>
    sealed class Stretch(int timeLine, string parent, ControlTime epoch)
    {
        BodyTruth _truth;
        ControlTime? _newest;

        public int TimeLine => timeLine;
        public List<PoseSample> Samples { get; } = [];

        public double Seconds(ControlTime t) => ClockTicks.Seconds(t - epoch);

        /// <summary>Whether the next pose belongs to this stretch. If its time stamp is far behind, the clock of the source went back.</summary>
        public bool Includes(int ofTimeLine, string ofParent, ControlTime at) =>
            ofTimeLine == timeLine && ofParent == parent && !(_newest is { } newest && ArrivalLimits.IsFarBehind(at, newest));

        public void Add(ControlTime at, in Vector3D position, in UnitQuaternion rotation)
        {
            if (!(at <= _newest)) _newest = at;
            Samples.Add(new PoseSample(Seconds(at), position, rotation));
        }

        // Sorted by time stamp, because samples can arrive in another order.
        public BodyTruth Truth => _truth ??= Samples.Count < 2 ? null : new BodyTruth([.. Samples.DistinctBy(sample => sample.Time).OrderBy(sample => sample.Time)]);
    }

    sealed class Body(Func<BodyPredictor> newPredictor, TimeSpan maximumGap)
    {
        const double MmPerMetre = 1000, DegreesPerRadian = 180 / Math.PI;

        readonly List<Stretch> _stretches = [];
        readonly BodyError _position = new();
        readonly BodyError _rotation = new();
        readonly BodyError _displayedPosition = new();
        readonly BodyError _displayedRotation = new();
        BodyPredictor _predictor;
        int _stretch = -1, _taken;
        double _displayed = double.NaN, _newest;
        // True pose in the newest frame; null if the frame is not scored.
        RigidTransform? _truth;

        public int Frames { get; private set; }

        public void AddTruth(int timeLine, string parent, ControlTime at, in Vector3D position, in UnitQuaternion rotation)
        {
            if (_stretches.Count == 0 || !_stretches[^1].Includes(timeLine, parent, at)) _stretches.Add(new Stretch(timeLine, parent, at));
            _stretches[^1].Add(at, position, rotation);
        }

        /// <summary>Passes the next sample, in the order of the file, to the predictor.</summary>
        public void Take(double stampError)
        {
            if (_stretch < 0 || _taken == _stretches[_stretch].Samples.Count)
            {
                _stretch++;
                _taken = 0;
                _displayed = double.NaN;
                _newest = double.NegativeInfinity;
                _predictor = newPredictor();
            }
            var sample = _stretches[_stretch].Samples[_taken++];
            _newest = Math.Max(_newest, sample.Time);
            _predictor.Add(new PoseSample(sample.Time + stampError, sample.Position, sample.Rotation, sample.Time), _displayed);
        }

        public void Show(int timeLine, ControlTime light, double latencyError)
        {
            _truth = null;
            if (_stretch < 0 || _stretches[_stretch].TimeLine != timeLine) return;
            var stretch = _stretches[_stretch];
            var time = stretch.Seconds(light);
            _displayed = time + latencyError;
            var predicted = _predictor.At(_displayed);
            var gap = ClockTicks.Seconds(maximumGap);
            if (_taken < SamplesBeforeScoring || time - _newest > gap || stretch.Truth is not { } truth || truth.GapAt(time) > gap) return;
            if (!BodyError.IsMoving(PoseAt, time)) return;
            var pose = PoseAt(time);
            _position.Add(_predictor.Hold.DistanceTo(pose), predicted.DistanceTo(pose));
            _rotation.Add(_predictor.Hold.AngleTo(pose), predicted.AngleTo(pose));
            Frames++;
            _truth = pose;

            RigidTransform PoseAt(double t)
            {
                var (x, y, z, rotation) = truth.At(t);
                return rotation.At(x, y, z);
            }
        }

        /// <summary>Scores the pose at which the session displayed the object in the newest frame.</summary>
        public void AddDisplayed(in RigidTransform pose)
        {
            if (_truth is not { } truth) return;
            _displayedPosition.Add(_predictor.Hold.DistanceTo(truth), pose.DistanceTo(truth));
            _displayedRotation.Add(_predictor.Hold.AngleTo(truth), pose.AngleTo(truth));
        }

        public BodyReplayResult Result(string name, string predictor) => new(
            name, predictor, Frames, _position.Summary(MmPerMetre), _rotation.Summary(DegreesPerRadian))
        {
            Displayed = _displayedPosition.Count == 0 ? null : (_displayedPosition.Summary(MmPerMetre), _displayedRotation.Summary(DegreesPerRadian)),
        };
    }
}
