using Nowpose.Benchmarks.Links;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>
/// Runs a session whose two connections are TCP streams over a packet link, at 60 fps in virtual time, and compares each frame with the
/// truth.
/// </summary>
sealed class TcpRun
{
    static readonly RobotModel Robot = RobotFiles.Load("youbot");
    static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);
    static readonly TimeSpan SamplingInterval = TimeSpan.FromMilliseconds(50);
    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(500);

    readonly PickAndPlaceMotion _motion = new PickAndPlaceMotion(Robot);
    readonly string[] _names;
    readonly VirtualClock _clock;
    readonly TcpStream _requests, _replies, _samples;
    readonly Queue<Arrival<JointStateMessage>> _underway = new Queue<Arrival<JointStateMessage>>();
    readonly ExchangePace _pace;
    readonly ForwardKinematics _kinematics = new ForwardKinematics(Robot);
    readonly RigidTransform[] _poses = new RigidTransform[Robot.Links.Count];
    readonly double[] _truth = new double[Robot.MovingJoints.Count];
    SyncExchange? _exchange;
    HeadsetTime _nextRequest = Start;
    HeadsetTime _lastSample = Start;

    public TcpRun(LinkProfile link, int seed)
    {
        _clock = new VirtualClock(Start, TimeSpan.FromSeconds(1000), (seed % 2 == 0 ? 1 : -1) * (10 + 20 * (seed % 3)) * 1e-6);
        _names = _motion.JointNames.ToArray();
        _requests = new TcpStream(link, Start, 10 * seed);
        _replies = new TcpStream(link, Start, 10 * seed + 1);
        _samples = new TcpStream(link, Start, 10 * seed + 2, SamplingInterval);
        Session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Visualisation), new PredictionSettings()),
            Robot, new StopwatchHeadsetClock());
        _pace = Session.Settings.NewExchangePace(new Random(seed));
    }

    public CompensationSession Session { get; }
    public List<Frame> Frames { get; } = new List<Frame>();

    public TcpRun Run(double seconds)
    {
        for (var i = 0; i < seconds * 60; i++)
        {
            var now = Start + TimeSpan.FromTicks((long)(i / 60.0 * TimeSpan.TicksPerSecond));
            Exchange(now);
            Sample(now);
            Frames.Add(Scored(Session.Tick(now), now));
        }
        return this;
    }

    public double FirstCurrent => Frames.First(frame => frame.IsCurrent).At;

    /// <summary>Share of current frames, from the first current frame on.</summary>
    public double CurrentShare => Since(FirstCurrent).Average(frame => frame.IsCurrent ? 1 : 0);

    /// <summary>1 − RMS error of the tool ÷ RMS error of hold, over all frames from the first current frame on, including held frames.</summary>
    public double Reduction => 1 - Math.Sqrt(
        Since(FirstCurrent).Sum(frame => frame.Error * frame.Error) / Since(FirstCurrent).Sum(frame => frame.HoldError * frame.HoldError));

    /// <summary>Share of the current frames in which the error of the clock exceeded the stated estimated error (±).</summary>
    public double ClockErrorBeyondStated =>
        Frames.Where(frame => frame.IsCurrent).Average(frame => Math.Abs(frame.ClockErrorMs) > frame.StatedMs ? 1 : 0);

    public double FirstIn(ClockState state) => Frames.First(frame => frame.Clock == state).At;

    IEnumerable<Frame> Since(double seconds) => Frames.Where(frame => frame.At >= seconds);

    void Exchange(HeadsetTime now)
    {
        while (true)
        {
            if (_exchange?.T4 <= now)
            {
                Session.Clock.Add(_exchange.Value, out _);
                var ended = _exchange.Value.T4;
                var due = _exchange.Value.T1 + _pace.Next(Session.Clock, ended);
                _nextRequest = due > ended ? due : ended;
                _exchange = null;
            }
            if (_exchange.HasValue || _nextRequest > now) return;
            var received = _requests.Send(_nextRequest);
            var sent = received + TimeSpan.FromMicroseconds(20);
            _exchange = new SyncExchange(_nextRequest, _clock.At(received), _clock.At(sent), _replies.Send(sent));
        }
    }

    void Sample(HeadsetTime now)
    {
        while (_lastSample + SamplingInterval <= now)
        {
            _lastSample += SamplingInterval;
            var positions = new double[_names.Length];
            _motion.At((_lastSample - Start).TotalSeconds, positions);
            var message = new JointStateMessage(_clock.At(_lastSample), _names, positions);
            _underway.Enqueue(new Arrival<JointStateMessage>(message, _samples.Send(_lastSample)));
        }
        while (_underway.Count > 0 && _underway.Peek().At <= now)
        {
            var arrival = _underway.Dequeue();
            Session.Listener.Received(arrival.Message, arrival.At);
        }
    }

    Frame Scored(DisplayFrame frame, HeadsetTime now)
    {
        _motion.At((now + Visualisation - Start).TotalSeconds, _truth);
        var truth = Tool(_truth);
        var error = frame.DisplayTime.HasValue ? (frame.DisplayTime.Value - _clock.At(now + Visualisation)).TotalMilliseconds : double.NaN;
        return new Frame(
            (now - Start).TotalSeconds, frame.State, frame.ClockState, error, frame.ClockError.TotalMilliseconds,
            Distance(frame.ToolPose, truth), Distance(Tool(frame.HeldJoints), truth));
    }

    RigidTransform Tool(ReadOnlySpan<double> joints)
    {
        _kinematics.Compute(joints, _poses);
        return _poses[Robot.IndexOfLink(Robot.ToolLink.Name)];
    }

    static double Distance(in RigidTransform a, in RigidTransform b) =>
        Math.Sqrt(Math.Pow(a.X - b.X, 2) + Math.Pow(a.Y - b.Y, 2) + Math.Pow(a.Z - b.Z, 2));

    /// <summary>A displayed frame and its errors. Times are in seconds since the start; errors of the tool are in metres.</summary>
    public sealed class Frame
    {
        public Frame(double at, PoseState state, ClockState clock, double clockErrorMs, double statedMs, double error, double holdError)
        {
            At = at;
            State = state;
            Clock = clock;
            ClockErrorMs = clockErrorMs;
            StatedMs = statedMs;
            Error = error;
            HoldError = holdError;
        }

        public double At { get; }
        public PoseState State { get; }
        public bool IsCurrent => State == PoseState.Current;
        public ClockState Clock { get; }
        public double ClockErrorMs { get; }
        public double StatedMs { get; }
        public double Error { get; }
        public double HoldError { get; }
    }
}
