using Nowpose.Anchoring;
using Nowpose.Cli.SessionFiles;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Cli.Replay;

/// <summary>Replays the tracked frames of a recorded session in virtual time, with one predictor per frame.</summary>
/// <remarks>
/// Events are processed in the order of the file, as for joints. The truth is interpolated between the last sample before the display time and the
/// first sample after it. It is unknown across a change of the parent, a restart of the source, and gaps. Poses are compared in the world, to which the
/// poses of the object and of all frames above it are composed; below the link of a robot, they are compared relative to this link, because a recording
/// does not have the poses of links. Displayed frames in which an object does not move, or in which the newest sample of the object or of a frame above it
/// is too old to be shown as current, are not scored.
/// </remarks>
sealed class SessionBodies
{
    /// <summary>Number of samples after which a tracked frame is scored; the same as for joints.</summary>
    const int SamplesBeforeScoring = 5;

    readonly RecordedSession _session;
    readonly ReplaySettings _settings;
    readonly RandomStream _stampErrors;
    readonly SortedDictionary<string, Body> _bodies = new(StringComparer.Ordinal);
    readonly Dictionary<string, PoseLine> _stationary = new(StringComparer.Ordinal);
    // The poses from an object up to the world or to the link of a robot; the body is null for a stationary frame.
    readonly List<(Body Body, RigidTransform Pose)> _path = [];

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
            if (line.IsStationary) continue;
            if (!_bodies.TryGetValue(line.Frame, out var body)) _bodies.Add(line.Frame, body = new Body(newPredictor, prediction.MaximumGap));
            body.AddTruth(pose.TimeLine, line.Parent, pose.At, line.Position, line.Rotation);
        }
    }

    /// <summary>
    /// Called for each value of each scored object in each frame, with the names of the object and of the frame in which its poses are compared.
    /// </summary>
    public Action<string, string, ScoredValue> Scored { get; init; }

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
            if (next.Kind == RecordedSession.EventKind.Pose) Take(_session.PoseOf(next));
            else if (next.Kind == RecordedSession.EventKind.Frame && next.IsTimed) Show(next);
            // The line of the frame is missing if the recording could not keep up.
            else if (next.Kind == RecordedSession.EventKind.Object && frame.IsTimed && (frame.At, frame.TimeLine) == (next.At, next.TimeLine))
            {
                var (name, pose) = _session.ObjectOf(next);
                if (_bodies.TryGetValue(name, out var body)) body.AddDisplayed(pose);
            }
        }
        return [.. _bodies.Where(body => body.Value.Frames > 0).Select(body => body.Value.Result(body.Key, _settings.Predictor))];
    }

    void Take(PoseLine pose)
    {
        if (pose.IsStationary)
        {
            _stationary[pose.Frame] = pose;
            return;
        }
        _stationary.Remove(pose.Frame);
        _bodies[pose.Frame].Take(_settings.StampError * (2 * _stampErrors.Next() - 1));
    }

    void Show(in RecordedSession.Event frame)
    {
        foreach (var body in _bodies.Values) body.Predict(frame.TimeLine, frame.At, _settings.LatencyError);
        foreach (var (name, body) in _bodies)
        {
            if (_stationary.ContainsKey(name) || !TryFindPath(name, out var root)) continue;
            if (!BodyMotion.IsMoving(seconds => Compose(each => each.TrueAt(seconds)), 0)) continue;
            var (held, predicted, truth) = (Compose(each => each.Held), Compose(each => each.Predicted), Compose(each => each.TrueAt(0)));
            body.Score(held, predicted, truth, isInWorld: root == FrameParents.World);
            if (Scored == null) continue;
            foreach (var value in BodyReplay.ValuesOf(frame.First, frame.At.SinceEpoch.Ticks, truth, held, predicted)) Scored(name, root, value);
        }
    }

    // Gets the world or the link of a robot. Returns false if the true pose of the object or of a frame above it is unknown.
    bool TryFindPath(string frame, out string root)
    {
        _path.Clear();
        while (_path.Count <= ProtocolLimits.FrameDepth)
        {
            if (_stationary.TryGetValue(frame, out var line))
            {
                _path.Add((null, line.Rotation.At(line.Position.X, line.Position.Y, line.Position.Z)));
                frame = line.Parent;
            }
            else if (_bodies.TryGetValue(frame, out var body) && body.IsKnown)
            {
                _path.Add((body, default));
                frame = body.Parent;
            }
            else
            {
                root = frame;
                return body == null;
            }
        }
        root = null;
        return false;
    }

    RigidTransform Compose(Func<Body, RigidTransform> poseOf)
    {
        var composed = RigidTransform.Identity;
        foreach (var (body, pose) in _path) composed = (body == null ? pose : poseOf(body)) * composed;
        return composed;
    }

    /// <summary>Consecutive poses of a tracked frame with the same parent, without a step of the clock or a restart of the source between them.</summary>
    sealed class Stretch(int timeLine, string parent, ControlTime epoch) : SampleRun(timeLine)
    {
        BodyTruth _truth;

        public string Parent => parent;
        public List<PoseSample> Samples { get; } = [];

        public double Seconds(ControlTime t) => ClockTicks.Seconds(t - epoch);

        public bool Includes(int ofTimeLine, string ofParent, ControlTime at) => ofParent == parent && Includes(ofTimeLine, at);

        public void Add(ControlTime at, in Vector3D position, in UnitQuaternion rotation)
        {
            Extend(at);
            Samples.Add(new PoseSample(Seconds(at), position, rotation));
        }

        // Sorted by time stamp, because samples can arrive in another order.
        public BodyTruth Truth => _truth ??= Samples.Count < 2 ? null : new BodyTruth([.. Samples.DistinctBy(sample => sample.Time).OrderBy(sample => sample.Time)]);
    }

    sealed class Body(Func<BodyPredictor> newPredictor, TimeSpan maximumGap)
    {
        const double MmPerMetre = 1000, DegreesPerRadian = 180 / Math.PI;

        readonly List<Stretch> _stretches = [];
        readonly ErrorCollector _position = new();
        readonly ErrorCollector _rotation = new();
        readonly ErrorCollector _displayedPosition = new();
        readonly ErrorCollector _displayedRotation = new();
        BodyPredictor _predictor;
        int _stretch = -1, _taken;
        double _displayed = double.NaN, _newest, _time;
        // Held and true pose in the world in the newest frame; null if the frame is not scored.
        (RigidTransform Held, RigidTransform Truth)? _scored;

        public int Frames { get; private set; }

        /// <summary>Whether the true pose in the newest frame is known, and the predicted pose would be shown as current.</summary>
        public bool IsKnown { get; private set; }

        public string Parent => _stretches[_stretch].Parent;

        /// <summary>Predicted pose in the parent in the newest frame.</summary>
        public RigidTransform Predicted { get; private set; }

        public RigidTransform Held => _predictor.Hold;

        /// <summary>Returns the true pose in the parent at a time after the display time of the newest frame, s.</summary>
        public RigidTransform TrueAt(double seconds)
        {
            var (x, y, z, rotation) = _stretches[_stretch].Truth.At(_time + seconds);
            return rotation.At(x, y, z);
        }

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

        public void Predict(int timeLine, ControlTime light, double latencyError)
        {
            (IsKnown, _scored) = (false, null);
            if (_stretch < 0 || _stretches[_stretch].TimeLine != timeLine) return;
            var stretch = _stretches[_stretch];
            _time = stretch.Seconds(light);
            _displayed = _time + latencyError;
            Predicted = _predictor.At(_displayed);
            var gap = ClockTicks.Seconds(maximumGap);
            IsKnown = _taken >= SamplesBeforeScoring && _time - _newest <= gap && stretch.Truth?.GapAt(_time) <= gap;
        }

        /// <summary>Scores the newest frame.</summary>
        /// <param name="isInWorld">Whether the poses are in the world, as those that the session displayed.</param>
        public void Score(in RigidTransform held, in RigidTransform predicted, in RigidTransform truth, bool isInWorld)
        {
            _position.Add(held.DistanceTo(truth), predicted.DistanceTo(truth));
            _rotation.Add(held.AngleTo(truth), predicted.AngleTo(truth));
            Frames++;
            if (isInWorld) _scored = (held, truth);
        }

        /// <summary>Scores the pose in the world at which the session displayed the object in the newest frame.</summary>
        public void AddDisplayed(in RigidTransform pose)
        {
            if (_scored is not var (held, truth)) return;
            _displayedPosition.Add(held.DistanceTo(truth), pose.DistanceTo(truth));
            _displayedRotation.Add(held.AngleTo(truth), pose.AngleTo(truth));
        }

        public BodyReplayResult Result(string name, string predictor) => new(
            name, predictor, Frames, _position.Result(MmPerMetre), _rotation.Result(DegreesPerRadian))
        {
            Displayed = _displayedPosition.Count == 0 ? null : (_displayedPosition.Result(MmPerMetre), _displayedRotation.Result(DegreesPerRadian)),
        };
    }
}
