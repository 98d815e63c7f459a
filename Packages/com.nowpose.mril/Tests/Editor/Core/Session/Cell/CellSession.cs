using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>
    /// Runs a session at 60 frames per second. Both clocks show the same time, and messages arrive 60 ms after their stamps.
    /// </summary>
    sealed class CellSession
    {
        public const double Visu = 0.04, Latency = 0.06, Interval = 0.05;

        double _nextSample;

        public CellSession(
            bool isClockKnown = true, string predictor = "linear", string robotNamespace = "", ConstantLatencyRange range = null,
            OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade)
        {
            Session = new CompensationSession(
                new SessionSettings(
                    new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Lengths.Seconds(Visu)), new PredictionSettings(predictor, blendMs: 0),
                    robotNamespace: robotNamespace, range: range, outsideRange: outsideRange),
                TestRobot.Model, new SetClock());
            if (isClockKnown) Synchronise();
        }

        public CompensationSession Session { get; }

        /// <summary>Start of the next frame, s.</summary>
        public double Now { get; private set; } = 20;

        /// <summary>Time by which the control clock has stepped, s.</summary>
        public double ClockStep { get; set; }

        /// <summary>Action that is called every 50 ms to send samples with the given stamp in s; null to send no samples.</summary>
        public Action<double> Sampling { get; set; }

        public void Synchronise()
        {
            for (var i = 0; i < 100; i++) Exchange(Now - 1 + i * 0.01);
        }

        /// <summary>Continues the run. <paramref name="seen"/> receives the display time of each frame in s.</summary>
        public void Run(double seconds, Action<double> seen = null)
        {
            if (_nextSample == 0) _nextSample = Now - 1;
            for (var end = Now + seconds - 1e-9; Now < end; Now += 1 / 60.0)
            {
                for (; _nextSample + Latency <= Now; _nextSample += Interval) Sampling?.Invoke(_nextSample);
                if (Session.Clock.ModelAt(At(Now)).IsKnown) Exchange(Now);
                Session.Tick(At(Now));
                seen?.Invoke(Now + Visu);
            }
        }

        /// <summary>Starts a new connection, over which no message has arrived yet.</summary>
        public void Reconnect() => Session.Listener.Connected(At(Now));

        /// <param name="pose">Pose of the child in its parent.</param>
        public void Send(string parent, string child, double stamp, in RigidTransform pose, bool isStationary = false) =>
            SendLate(parent, child, stamp, stamp, pose, isStationary);

        /// <param name="sent">Time at which the pose is sent, s.</param>
        public void SendLate(string parent, string child, double stamp, double sent, in RigidTransform pose, bool isStationary = false) =>
            Session.Listener.FramesReceived(
                new TransformsMessage(pose.ToTransform(ControlTime.FromSeconds(stamp), parent, child)), isStationary, At(sent + Latency));

        public void Send(string signal, double stamp, double value) => Session.Listener.SignalsReceived(
            new SignalsMessage(ControlTime.FromSeconds(stamp), new SignalValue(signal, value)), At(stamp + Latency));

        public void SendJoints(double stamp, double shoulder, double elbow, string robot = "") => Session.Listener.Received(
            new JointStateMessage(ControlTime.FromSeconds(stamp), new[] { "shoulder", "elbow" }, new[] { shoulder, elbow }),
            At(stamp + Latency), robot);

        static HeadsetTime At(double seconds) => HeadsetTime.FromSeconds(seconds);

        void Exchange(double at)
        {
            var control = ControlTime.FromSeconds(at + ClockStep);
            Session.Clock.Add(new SyncExchange(At(at) - Lengths.Ms(1), control, control, At(at) + Lengths.Ms(1)), out _);
        }
    }
}
