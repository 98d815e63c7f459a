using System;
using System.IO;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Tests;
using Nowpose.Tests.Core.Kinematics;

namespace Nowpose.Mono.Aot
{
    /// <summary>Runs and records a session with a simulated youBot over good WiFi, at 60 fps in virtual time.</summary>
    sealed class VirtualSession : IDisposable
    {
        const int FramesPerSecond = 60;
        const int Seconds = 12;
        const int ScoredFrom = 4;

        static readonly HeadsetTime Start = HeadsetTime.FromSeconds(500);
        static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);
        static readonly RobotModel Robot = UrdfFiles.Robot("youbot");

        readonly string _predictor;
        readonly CompensationSession _session;
        readonly VirtualCell _cell;
        readonly ForwardKinematics _kinematics = new ForwardKinematics(Robot);
        readonly double[] _truth = new double[Robot.MovingJoints.Count];
        readonly RigidTransform[] _poses = new RigidTransform[Robot.Links.Count];
        readonly int _tool = Robot.IndexOfLink(Robot.ToolLink.Name);
        double _squares, _holdSquares;

        public VirtualSession(string predictor, string estimator)
        {
            _predictor = predictor;
            _session = new CompensationSession(
                new SessionSettings(
                    new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Visualisation), new PredictionSettings(predictor),
                    clockEstimator: estimator),
                Robot, new StopwatchHeadsetClock());
            _cell = new VirtualCell(
                new PickAndPlaceMotion(Robot), new VirtualClock(Start, TimeSpan.FromSeconds(1000), 37e-6),
                new VirtualCellSettings(50, 55, 105, 2, 0.01, NetworkProfile.All[1]), 1, Start);
        }

        public void Check()
        {
            var path = Path.GetTempFileName();
            try
            {
                using (var recorder = new SessionRecorder(_session, new RecordingSettings(path)))
                {
                    for (var i = 0; i < Seconds * FramesPerSecond; i++) Frame(i);
                    recorder.Dispose();
                    recorder.Ended.Wait();
                    Program.Require(recorder.Problem == null, "recording: " + recorder.Problem);
                }
                Program.Require(new FileInfo(path).Length > 10_000, "the recording has content");
            }
            finally
            {
                File.Delete(path);
            }
            var ratio = Math.Sqrt(_squares / _holdSquares);
            // Hold shows the newest sample, like an uncompensated headset. The error of any other predictor must be less than half the error of hold.
            Program.Require(_holdSquares > 0 && (_predictor == "hold" ? ratio > 0.9 && ratio < 1.1 : ratio < 0.5), "error over that of hold: " + ratio);
        }

        public void Dispose() => _session.Dispose();

        void Frame(int index)
        {
            var now = Start + TimeSpan.FromTicks(index * TimeSpan.TicksPerSecond / FramesPerSecond);
            _cell.Run(now, _session);
            var frame = _session.Tick(now);
            if (index < ScoredFrom * FramesPerSecond) return;
            Program.Require(frame.State == (_predictor == "hold" ? PoseState.Held : PoseState.Current), "frame " + index + " is " + frame.State);
            _cell.TruthAt(frame.Start + Visualisation, _truth);
            var truth = Tool(_truth);
            _squares += Math.Pow(Distance.Between(frame.ToolPose, truth), 2);
            _holdSquares += Math.Pow(Distance.Between(Tool(frame.HeldJoints), truth), 2);
        }

        RigidTransform Tool(ReadOnlySpan<double> joints)
        {
            _kinematics.Compute(joints, _poses);
            return _poses[_tool];
        }
    }
}
