using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Tests.Core.Kinematics;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Runs a session with a virtual cell and a youBot at 60 fps in virtual time, and compares each frame with the truth.</summary>
    sealed class VirtualCellRun
    {
        static readonly RobotModel Robot = UrdfFiles.Robot("youbot");
        static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);
        static readonly HeadsetTime Start = HeadsetTime.FromSeconds(500);

        readonly ForwardKinematics _kinematics = new ForwardKinematics(Robot);
        readonly RigidTransform[] _truePoses = new RigidTransform[Robot.Links.Count];
        readonly RigidTransform[] _heldPoses = new RigidTransform[Robot.Links.Count];
        readonly double[] _truth = new double[Robot.MovingJoints.Count];
        readonly double _fps;
        long _frames;

        public VirtualCellRun(VirtualCellSettings settings, int seed = 1, double fps = 60, string predictor = Predictors.Default)
        {
            _fps = fps;
            Clock = new VirtualClock(Start, TimeSpan.FromSeconds(1000), 37e-6);
            var motion = new PickAndPlaceMotion(Robot);
            CycleSeconds = motion.CycleSeconds;
            Cell = new VirtualCell(motion, Clock, settings, seed, Start);
            Session = new CompensationSession(
                new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Visualisation), new PredictionSettings(predictor)),
                Robot, new StopwatchHeadsetClock());
            Session.Intake.SampleTaken += (arrival, _) => Taken.Add(arrival);
        }

        /// <summary>Period of the motion, s.</summary>
        public double CycleSeconds { get; }

        public VirtualCell Cell { get; }
        public VirtualClock Clock { get; }
        public CompensationSession Session { get; }
        public List<Arrival<JointStateMessage>> Taken { get; } = new List<Arrival<JointStateMessage>>();

        /// <summary>Distance of the displayed tool from the true tool in m, for the current frames since the last <see cref="Run"/>.</summary>
        public List<double> Errors { get; } = new List<double>();

        /// <summary>Distance of the uncompensated tool from the true tool in m, for the same frames as <see cref="Errors"/>.</summary>
        public List<double> HoldErrors { get; } = new List<double>();

        public int Frames { get; private set; }
        public HeadsetTime Now => Start + TimeSpan.FromTicks((long)(_frames / _fps * TimeSpan.TicksPerSecond));
        public SessionStatistics Statistics => Session.Statistics(Now);

        public static VirtualCellSettings Settings(
            double samplingMs = 50, double latencyMinMs = 55, double latencyMaxMs = 105, double jitterMs = 0, double loss = 0) =>
            new VirtualCellSettings(samplingMs, latencyMinMs, latencyMaxMs, jitterMs, loss, NetworkProfile.Lan);

        public VirtualCellRun Run(double seconds)
        {
            Errors.Clear();
            HoldErrors.Clear();
            Frames = 0;
            for (var end = _frames + (long)Math.Round(seconds * _fps); _frames < end; _frames++)
            {
                Cell.Run(Now, Session);
                Score(Session.Tick(Now));
            }
            return this;
        }

        /// <summary>Skips time without running the cell.</summary>
        public void Sleep(double seconds) => _frames += (long)Math.Round(seconds * _fps);

        void Score(DisplayFrame frame)
        {
            Frames++;
            if (frame.State != PoseState.Current) return;
            Cell.TruthAt(frame.Start + Visualisation, _truth);
            _kinematics.Compute(_truth, _truePoses);
            _kinematics.Compute(frame.HeldJoints, _heldPoses);
            var tool = Robot.IndexOfLink(Robot.ToolLink.Name);
            Errors.Add(Distance(frame.ToolPose, _truePoses[tool]));
            HoldErrors.Add(Distance(_heldPoses[tool], _truePoses[tool]));
        }

        static double Distance(in RigidTransform a, in RigidTransform b) =>
            Math.Sqrt(Math.Pow(a.X - b.X, 2) + Math.Pow(a.Y - b.Y, 2) + Math.Pow(a.Z - b.Z, 2));
    }
}
