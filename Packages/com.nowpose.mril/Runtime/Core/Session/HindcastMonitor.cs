using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>How far the tool was displayed from where it truly was, as the samples that came later tell; of the hold likewise.</summary>
    /// <remarks>
    /// The truth at a display time is the forward kinematics of the joints on the straight lines between their samples before
    /// and after. It can be no better than the samples: what they all share, an error of the clock or of L_visu, it cannot
    /// see, and motion between samples only as far as the line follows it. Allocates nothing once made; one thread.
    /// </remarks>
    sealed class HindcastMonitor
    {
        const double MillimetresPerMetre = 1000;

        /// <summary>Less than this the hold errs only while the robot rests, and of nothing nothing can be removed.</summary>
        const double LeastHoldErrorMm = 0.1;

        readonly RobotModel _robot;
        readonly ForwardKinematics _kinematics;
        readonly int _toolLink;
        readonly TimeSpan _maximumGap;
        readonly int[] _joints;
        readonly int[] _placeOfJoint;
        readonly bool[] _given;
        readonly Newest[] _newest;
        readonly ShownFrames _frames;
        readonly ErrorWindow _window = new ErrorWindow();
        readonly double[] _truth;
        readonly double[] _positions;
        readonly RigidTransform[] _linkPoses;
        ControlTime? _now;

        /// <param name="maximumGap">Between samples that lie further apart nobody knows how the robot moved.</param>
        public HindcastMonitor(RobotModel robot, TimeSpan maximumGap)
        {
            _robot = robot;
            _kinematics = new ForwardKinematics(robot);
            _toolLink = robot.IndexOfLink(robot.ToolLink.Name);
            _maximumGap = maximumGap;
            _joints = SampledJointsOf(robot);
            _placeOfJoint = new int[robot.MovingJoints.Count];
            _given = new bool[robot.MovingJoints.Count];
            for (var i = 0; i < _placeOfJoint.Length; i++)
            {
                _placeOfJoint[i] = Array.IndexOf(_joints, i);
                _given[i] = robot.MovingJoints[i].Mimic == null;
            }
            _newest = new Newest[_joints.Length];
            _frames = new ShownFrames(_joints.Length);
            _truth = new double[_joints.Length];
            _positions = new double[robot.MovingJoints.Count];
            _linkPoses = new RigidTransform[robot.Links.Count];
        }

        /// <summary>RMS distance of the displayed tool from the truth over the newest ten seconds, mm; null while unknown.</summary>
        public double? ErrorMm => TryRead(out var displayed, out _) ? displayed : (double?)null;

        /// <summary>The same of the uncompensated hold, mm.</summary>
        public double? HoldErrorMm => TryRead(out _, out var held) ? held : (double?)null;

        /// <summary>1 − displayed ÷ hold; negative where compensation makes it worse, null while unknown and while the robot rests.</summary>
        public double? Reduction =>
            TryRead(out var displayed, out var held) && held >= LeastHoldErrorMm ? 1 - displayed / held : (double?)null;

        /// <summary>A frame as it is displayed. Without a trusted time nothing is known of it, nor of the error now.</summary>
        public void Shown(DisplayFrame frame)
        {
            _now = frame.IsTimeTrusted ? frame.DisplayTime : null;
            // Outside the range the light appears at another time than the display time.
            if (_now == null || frame.State == PoseState.Incomplete || frame.Range == RangeState.Outside) return;
            foreach (ref readonly var newest in _newest.AsSpan())
                if (!newest.IsKnown || newest.At >= _now.Value) return;
            _kinematics.Compute(frame.HeldJoints, _linkPoses);
            _frames.Add(_now.Value, frame.ToolPose, _linkPoses[_toolLink]);
        }

        /// <summary>Samples that have arrived: they tell the truth about frames shown before.</summary>
        public void Add(JointStateMessage message)
        {
            for (var i = 0; i < message.Names.Length; i++)
            {
                var joint = _robot.IndexOfMovingJoint(message.Names[i]);
                if (joint >= 0 && _placeOfJoint[joint] >= 0) Add(_placeOfJoint[joint], message.Stamp, message.Positions[i]);
            }
            while (_frames.TryTakeFirst(out var frame, _truth)) Judge(frame);
        }

        /// <summary>Forgets all: times of before belong to another time line.</summary>
        public void Reset()
        {
            Array.Clear(_newest, 0, _newest.Length);
            _frames.Clear();
            _window.Reset();
            _now = null;
        }

        // A sample that was overtaken comes too late: its interval is told already.
        void Add(int place, ControlTime at, double position)
        {
            ref var newest = ref _newest[place];
            if (newest.IsKnown && at <= newest.At) return;
            if (newest.IsKnown) _frames.Tell(place, newest.At, newest.Position, at, position, at - newest.At <= _maximumGap);
            newest = new Newest { IsKnown = true, At = at, Position = position };
        }

        void Judge(in ShownFrames.Frame frame)
        {
            for (var i = 0; i < _joints.Length; i++) _positions[_joints[i]] = _truth[i];
            _robot.CompleteMimics(_positions, _given);
            _kinematics.Compute(_positions, _linkPoses);
            ref readonly var truth = ref _linkPoses[_toolLink];
            _window.Add(
                frame.At, SquareOf(frame.X - truth.X, frame.Y - truth.Y, frame.Z - truth.Z),
                SquareOf(frame.HeldX - truth.X, frame.HeldY - truth.Y, frame.HeldZ - truth.Z));
        }

        static double SquareOf(double x, double y, double z) => x * x + y * y + z * z;

        bool TryRead(out double displayedMm, out double heldMm)
        {
            displayedMm = heldMm = 0;
            if (_now == null || !_window.TryRead(_now.Value, out var displayed, out var held)) return false;
            displayedMm = displayed * MillimetresPerMetre;
            heldMm = held * MillimetresPerMetre;
            return true;
        }

        // The joints that the tool hangs on; in the place of one that mimics, the one with samples at the end of the chain.
        static int[] SampledJointsOf(RobotModel robot)
        {
            var joints = new List<int>();
            for (var link = robot.ToolLink; link.ParentIndex >= 0; link = robot.Links[link.ParentIndex])
            {
                var joint = link.ParentJoint;
                if (joint.MovingIndex < 0) continue;
                while (joint.Mimic != null) joint = robot.MovingJoints[robot.IndexOfMovingJoint(joint.Mimic.Master)];
                if (!joints.Contains(joint.MovingIndex)) joints.Add(joint.MovingIndex);
            }
            return joints.ToArray();
        }

        struct Newest
        {
            public bool IsKnown;
            public ControlTime At;
            public double Position;
        }
    }
}
