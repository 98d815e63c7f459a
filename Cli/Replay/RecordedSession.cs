using Nowpose.Cli.SessionFiles;
using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Cli.Replay;

/// <summary>The data of a session file that a replay needs, in the order in which the session processed them, in a compact form.</summary>
sealed class RecordedSession
{
    /// <summary>Maximum number of stored values, about 400 MB. A session file of the default maximum size contains fewer.</summary>
    const int MaxNumbers = 50_000_000;

    /// <summary>Number of values per pose: position, quaternion and time stamp; and per displayed object: position, rotation matrix, name and event.</summary>
    const int NumbersPerPose = 8, NumbersPerObject = 17;

    // Drop reasons of samples that reached no predictor in the session. The replay drops these samples, too.
    static readonly string[] NeverTaken = ["slow_reader", "stamp_in_future"];

    /// <summary>Interval of the simulated frames that replace those of a headset.</summary>
    static readonly TimeSpan FrameInterval = new(TimeSpan.TicksPerSecond / 60);

    readonly string _path;
    readonly List<SessionHeader.Joint> _joints = [];
    readonly Dictionary<string, int> _indices = [];
    readonly List<Event> _events = [];
    readonly List<Value> _values = [];
    readonly List<PlannedMotion> _plans = [];
    readonly List<PoseLine> _poses = [];
    readonly List<(string Frame, RigidTransform Pose)> _objects = [];
    readonly Dictionary<string, (double Value, int Changes)> _signals = [];
    int _line, _timeLine;
    bool _isComplete;
    long _planned;
    ControlTime? _nextFrame;

    RecordedSession(string path, SessionHeader header)
    {
        _path = path;
        Header = header;
        foreach (var joint in header.Joints) Add(joint);
    }

    /// <summary>
    /// The header of the file, with the joints of all robots. If the file does not describe the robot without a namespace, its joints are those named in
    /// the samples.
    /// </summary>
    public SessionHeader Header { get; private set; }

    public IReadOnlyList<Event> Events => _events;

    public int Frames { get; private set; }

    /// <summary>Number of lines that are missing because the recording could not keep up.</summary>
    public long Lost { get; private set; }

    /// <summary>Gets the reasons why the recording is incomplete, in one line each.</summary>
    public IEnumerable<string> Warnings()
    {
        if (Lost > 0) yield return SessionFileMessages.LinesLost(Lost);
        if (CutOff is { } end) yield return SessionFileMessages.NoEnd(end);
    }

    /// <exception cref="InputException">The file cannot be read or has another format.</exception>
    public static RecordedSession Read(string path)
    {
        using var file = new SessionFileReader(path);
        var session = new RecordedSession(path, file.Header);
        foreach (var line in file.Lines())
        {
            session._line = file.Line;
            session.Add(line);
        }
        session.Header = file.Header with { Joints = session._joints };
        return session;
    }

    /// <summary>Gets the joint values of a sample event.</summary>
    public ReadOnlySpan<Value> ValuesOf(in Event sample) =>
        System.Runtime.InteropServices.CollectionsMarshal.AsSpan(_values).Slice(sample.First, sample.Count);

    // End of the results of an incomplete recording: time of the last event with a known time. Null if the recording is complete or has no events.
    ControlTime? CutOff => !_isComplete && _events.FindLast(one => one.IsTimed) is { IsTimed: true } last ? last.At : null;

    void Add(SessionLine line)
    {
        switch (line)
        {
            case RobotLine robot:
                foreach (var joint in robot.Joints) Add(joint);
                break;
            case SampleLine sample when Array.IndexOf(NeverTaken, sample.Dropped) < 0: Add(sample); break;
            case PlanLine { Dropped: null } plan: Add(plan); break;
            case PoseLine { Dropped: null } pose: Add(pose); break;
            case ObjectLine { IsCurrent: true } shown: Add(shown); break;
            case SignalLine { Dropped: null } signal: Add(signal); break;
            case FrameLine frame: Add(frame); break;
            case ClockChangeLine { IsNewStart: true }: StartTimeLine(); break;
            case LostLine lost: Lost += lost.Count; break;
            case EndLine: _isComplete = true; break;
        }
        if (_values.Count + _planned + NumbersPerPose * (long)_poses.Count + NumbersPerObject * (long)_objects.Count > MaxNumbers)
            throw new InputException(ReplayMessages.TooLong(_path, MaxNumbers));
    }

    /// <summary>The signals, sorted by name, with the number of their changes.</summary>
    public IReadOnlyList<(string Name, int Changes)> Signals =>
        [.. _signals.OrderBy(signal => signal.Key, StringComparer.Ordinal).Select(signal => (signal.Key, signal.Value.Changes))];

    /// <summary>Gets the pose of a pose event.</summary>
    public PoseLine PoseOf(in Event pose) => _poses[pose.First];

    /// <summary>Gets the displayed pose of an object event in the world, and the name of its frame.</summary>
    public (string Frame, RigidTransform Pose) ObjectOf(in Event shown) => _objects[shown.First];

    void Add(PoseLine pose)
    {
        if (!pose.IsStationary && pose.ControlArrival is { } arrival) AddFramesUntil(arrival);
        _events.Add(new Event(EventKind.Pose, pose.Stamp, true, _timeLine, _poses.Count, 1));
        _poses.Add(pose);
    }

    void Add(ObjectLine shown)
    {
        if (shown.Light is not { } light) return;
        _events.Add(new Event(EventKind.Object, light, true, _timeLine, _objects.Count, 1));
        _objects.Add((string.Intern(shown.Frame), shown.Pose));
    }

    // A source repeats the current value for each new connection. A repeated value is not counted as a change.
    void Add(SignalLine signal) => _signals[signal.Name] = _signals.TryGetValue(signal.Name, out var known)
        ? (signal.Value, known.Changes + (signal.Value == known.Value ? 0 : 1)) : (signal.Value, 0);

    /// <summary>Gets the set-points of a plan event for the joints of the header.</summary>
    public PlannedMotion PlanOf(in Event plan) => _plans[plan.First];

    void Add(SampleLine sample)
    {
        if (sample.ControlArrival is { } arrival) AddFramesUntil(arrival);
        if (Header.RobotJoints == 0)
            foreach (var name in sample.Names)
                if (!_indices.ContainsKey(name)) Add(new SessionHeader.Joint(name, "rad", JointLimits.None));
        var first = _values.Count;
        for (var i = 0; i < sample.Names.Length; i++)
            if (_indices.TryGetValue(sample.Names[i], out var joint)) _values.Add(new Value(
                joint, sample.Positions[i], sample.Velocities?[i] ?? double.NaN, sample.Accelerations?[i] ?? double.NaN));
        _events.Add(new Event(EventKind.Sample, sample.Stamp, true, _timeLine, first, _values.Count - first));
    }

    // A gateway displays nothing. Adds the frames of a headset that would receive and display each sample immediately.
    void AddFramesUntil(ControlTime arrival)
    {
        var next = _nextFrame ?? arrival;
        // Adds no frames for the time in which the source was not connected.
        if (next + Header.Prediction.MaximumGap < arrival) next = arrival;
        for (; next < arrival; next += FrameInterval)
        {
            _events.Add(new Event(EventKind.Frame, next, true, _timeLine, Frames++, 1));
        }
        _nextFrame = next;
    }

    void StartTimeLine()
    {
        _timeLine++;
        _nextFrame = null;
    }

    // The first description of a joint applies, so that a further robot does not change a joint of the header.
    void Add(SessionHeader.Joint joint)
    {
        if (_indices.TryAdd(joint.Name, _joints.Count)) _joints.Add(joint);
    }

    void Add(PlanLine line)
    {
        var plan = PlannedMotion.Of(line.Arrival, name => _indices.GetValueOrDefault(name, -1));
        _events.Add(new Event(EventKind.Plan, plan.Stamp, true, _timeLine, _plans.Count, plan.Count));
        _plans.Add(plan);
        // Counts position, velocity and acceleration twice: in the message, and in the paths created from it.
        _planned += 6L * line.Arrival.Message.Names.Length * line.Arrival.Message.Points.Count;
    }

    void Add(FrameLine frame)
    {
        if (frame.Joints.Length != Header.RobotJoints)
            throw new InputException(ReplayMessages.JointCount(_path, _line, frame.Joints.Length, Header.RobotJoints));
        _events.Add(new Event(EventKind.Frame, frame.Light ?? default, frame.Light.HasValue, _timeLine, Frames++, 1));
    }

    public enum EventKind
    {
        Sample,
        Plan,
        Pose,
        Frame,
        Object,
    }

    /// <summary>A sample, plan or pose that the replay processes, or a frame, or an object that was displayed as current in the frame before it.</summary>
    /// <param name="At">t_k of a sample or pose, time stamp of a plan, or display time of a frame or object.</param>
    /// <param name="IsTimed">Whether the display time of a frame is known; true for other events.</param>
    /// <param name="TimeLine">
    /// Number of the time line, which increases when the session discards all samples. Times of different lines are not comparable.
    /// </param>
    /// <param name="First">Index of the first joint value; for a plan, pose, frame or object, its index among the events of this kind.</param>
    /// <param name="Count">Number of joint values of a sample, number of joints of a plan, or 1 for other events.</param>
    public readonly record struct Event(EventKind Kind, ControlTime At, bool IsTimed, int TimeLine, int First, int Count);

    /// <param name="Joint">Index of the joint in the header.</param>
    /// <param name="Position">Position, rad or m.</param>
    /// <param name="Velocity">Velocity, rad/s or m/s; NaN if unknown.</param>
    /// <param name="Acceleration">Acceleration, rad/s² or m/s²; NaN if unknown.</param>
    public readonly record struct Value(int Joint, double Position, double Velocity, double Acceleration);
}
