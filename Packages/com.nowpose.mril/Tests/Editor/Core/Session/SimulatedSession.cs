using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Tests.Core.Sync;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>
    /// Simulates a whole session in virtual time, with a moving robot, a network, two clocks and frames at 60 fps by default. The simulation never
    /// waits in real time, and all random numbers are seeded.
    /// </summary>
    sealed class SimulatedSession
    {
        const double SampleSeconds = 0.05;
        static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);

        readonly PathDelay _sampleDelay;
        readonly Random _random;
        readonly Queue<(HeadsetTime At, JointStateMessage Message)> _underway = new Queue<(HeadsetTime, JointStateMessage)>();
        SyncExchange? _exchange;
        double _nextFrame, _nextSample, _nextExchange;
        HeadsetTime _lastArrival;
        bool _isElbowNext;

        public SimulatedSession(
            NetworkProfile network, int seed, string predictor = "quadratic", ConstantLatencyRange range = null,
            OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade, RobotModel robot = null)
        {
            Link = new SimulatedLink(network, seed, skewPpm: 45, skewVariationPpm: 2);
            _sampleDelay = network.Down(seed + 1000);
            _random = new Random(seed);
            Session = new CompensationSession(
                new SessionSettings(
                    new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Visualisation), new PredictionSettings(predictor), range: range,
                    outsideRange: outsideRange),
                robot ?? TestRobot.Model, new NoClock());
        }

        public CompensationSession Session { get; }
        public SimulatedLink Link { get; }

        /// <summary>Whether the control system sends samples and replies.</summary>
        public bool IsGatewayUp { get; set; } = true;

        /// <summary>Whether sync exchanges succeed.</summary>
        public bool IsSyncUp { get; set; } = true;

        /// <summary>Whether each joint is sampled at its own time and sent in its own message.</summary>
        public bool IsEachJointApart { get; set; }

        /// <summary>Whether the test sends the samples instead of the simulation.</summary>
        public bool IsSamplingByTest { get; set; }

        /// <summary>Error of the clock that stamps the samples, s; positive if it is ahead of the control clock.</summary>
        public double StampErrorSeconds { get; set; }

        /// <summary>Name of the joint that samples do not contain; null if samples contain all joints.</summary>
        public string SilentJoint { get; set; }

        /// <summary>Time between two frames, s.</summary>
        public double FrameSeconds { get; set; } = 1 / 60.0;

        public double Now { get; private set; }

        /// <summary>Latency of each sample from the robot to the headset, ms.</summary>
        public List<double> TrueLatenciesMs { get; } = new List<double>();

        /// <summary>True joint positions in rad. The robot's motion is a function of headset time in s.</summary>
        public static (double Shoulder, double Elbow) TruthAt(double seconds) =>
            (Math.Sin(seconds * 1.3), 0.8 * Math.Sin(seconds * 0.9 + 1));

        /// <summary>Continues the run. <paramref name="seen"/> receives each frame and its display time in s.</summary>
        public void Run(double seconds, Action<DisplayFrame, double> seen = null)
        {
            for (var end = Now + seconds; Now < end; Now += 0.0005)
            {
                var now = HeadsetTime.FromSeconds(Now);
                Deliver(now);
                if (Now >= _nextSample) Sample(now);
                if (Now >= _nextExchange) Exchange(now);
                if (Now < _nextFrame) continue;
                _nextFrame += FrameSeconds;
                var frame = Session.Tick(now);
                seen?.Invoke(frame, Now + Visualisation.TotalSeconds);
            }
        }

        void Deliver(HeadsetTime now)
        {
            while (_underway.Count > 0 && _underway.Peek().At <= now)
            {
                var (at, message) = _underway.Dequeue();
                Session.Listener.Received(message, at);
            }
            if (_exchange?.T4 > now) return;
            if (_exchange.HasValue) Session.Clock.Add(_exchange.Value, out _);
            _exchange = null;
        }

        void Sample(HeadsetTime now)
        {
            _nextSample += IsEachJointApart ? SampleSeconds / 2 : SampleSeconds;
            if (!IsGatewayUp || IsSamplingByTest) return;
            var (shoulder, elbow) = TruthAt(now.SinceEpoch.TotalSeconds);
            var stamp = Link.TrueOffset(now).ToControl(now) + Lengths.Seconds(StampErrorSeconds);
            var message = new JointStateMessage(stamp, new[] { "elbow", "shoulder" }, new[] { elbow, shoulder });
            _isElbowNext = !_isElbowNext;
            if (IsEachJointApart && _isElbowNext) message = new JointStateMessage(stamp, new[] { "elbow" }, new[] { elbow });
            else if (IsEachJointApart) message = new JointStateMessage(stamp, new[] { "shoulder" }, new[] { shoulder });
            message = Without(SilentJoint, message);
            if (message.Names.Length == 0) return;
            var acquisition = Lengths.Ms(55 + 50 * _random.NextDouble());
            var at = now + acquisition + _sampleDelay.Next();
            if (at < _lastArrival) at = _lastArrival;
            _lastArrival = at;
            TrueLatenciesMs.Add((at - now).TotalMilliseconds);
            _underway.Enqueue((at, message));
        }

        static JointStateMessage Without(string joint, JointStateMessage message)
        {
            var kept = Enumerable.Range(0, message.Names.Length).Where(i => message.Names[i] != joint).ToArray();
            return new JointStateMessage(
                message.Stamp, kept.Select(i => message.Names[i]).ToArray(), kept.Select(i => message.Positions[i]).ToArray());
        }

        void Exchange(HeadsetTime now)
        {
            _nextExchange += 0.2;
            if (IsGatewayUp && IsSyncUp && _exchange == null && Link.TryExchange(now, out var exchange)) _exchange = exchange;
        }

        sealed class NoClock : IHeadsetClock
        {
            public HeadsetTime Now => throw new InvalidOperationException("a session without network reads no clock");
        }
    }
}
