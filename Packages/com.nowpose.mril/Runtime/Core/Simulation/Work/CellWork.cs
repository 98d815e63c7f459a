using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>
    /// The work of a robot that picks and places: a conveyor brings workpieces, the gripper takes one per cycle and puts it on a fixture, from
    /// which the conveyor takes it again. A function of time; immutable, so any thread may use it.
    /// </summary>
    sealed class CellWork
    {
        /// <summary>Names of the stationary frames. Their z axes point up; x and y are those of the robot's base.</summary>
        public const string Conveyor = "conveyor", Fixture = "fixture";

        /// <summary>Names of the signals: whether the gripper is closed, whether the belt moves, whether a workpiece waits to be taken.</summary>
        public const string GripperClosed = "gripper_closed", BeltRunning = "belt_running", PartPresent = "part_present";

        /// <summary>The signals, in the order of <see cref="SignalsAt"/>.</summary>
        public static readonly IReadOnlyList<string> Signals = new[] { GripperClosed, BeltRunning, PartPresent };

        /// <summary>Frames of the workpieces. The belt has as many steps.</summary>
        public static readonly IReadOnlyList<string> Names = new[] { "workpiece_1", "workpiece_2", "workpiece_3" };

        /// <summary>Edge length of a workpiece, a cube whose frame is in its centre, m.</summary>
        public const double Size = 0.03;

        /// <summary>Share of the time between putting down and taking that the belt waits, so that the gripper is away.</summary>
        const double WaitShare = 0.25;

        /// <summary>Share of that time in which the step must be complete.</summary>
        const double StepShare = 0.65;

        readonly IGrippingMotion _motion;
        readonly RobotModel _robot;
        readonly RingConveyor _conveyor;
        readonly RigidTransform _toConveyor, _toFixture;
        readonly string _tool;
        readonly double _held, _wait;

        public CellWork(RobotModel robot, IGrippingMotion motion)
        {
            _robot = robot;
            _motion = motion;
            _tool = robot.ToolLink.Name;
            var (taken, released) = (ToolAt(motion.GripSeconds), ToolAt(motion.ReleaseSeconds));
            var upright = RigidTransform.FromXyzRpy(taken.X, taken.Y, taken.Z, 0, 0, Math.Atan2(taken.Y, taken.X));
            InTool = taken.Inverse * upright;
            var placed = released * InTool;
            _held = motion.ReleaseSeconds - motion.GripSeconds;
            var between = motion.CycleSeconds - _held;
            _wait = WaitShare * between;
            _conveyor = new RingConveyor(placed, upright, Names.Count, StepShare * between);
            ConveyorPose = RigidTransform.FromXyzRpy(0, 0, upright.Z - Size / 2, 0, 0, 0);
            FixturePose = RigidTransform.FromXyzRpy(placed.X, placed.Y, placed.Z - Size / 2, 0, 0, 0);
            _toConveyor = ConveyorPose.Inverse;
            _toFixture = FixturePose.Inverse;
        }

        /// <summary>Pose of a gripped workpiece in the link of the tool.</summary>
        public RigidTransform InTool { get; }

        /// <summary>Pose of the conveyor in the robot's base frame: the axis of the ring, at the height where workpieces are taken.</summary>
        public RigidTransform ConveyorPose { get; }

        /// <summary>Pose of the fixture in the robot's base frame: the middle of its upper side.</summary>
        public RigidTransform FixturePose { get; }

        /// <summary>Returns the pose of a workpiece in its parent, and the parent's name.</summary>
        /// <param name="seconds">Time since the start of the robot's motion, s.</param>
        public RigidTransform PoseOf(int workpiece, double seconds, out string parent)
        {
            var passed = SinceTaken(workpiece, seconds);
            parent = passed < _held ? _tool : passed < _held + _wait / 2 ? Fixture : Conveyor;
            if (passed < _held) return InTool;
            return (parent == Fixture ? _toFixture : _toConveyor) * OnBelt(passed);
        }

        /// <summary>Returns the pose of a workpiece in the robot's base frame.</summary>
        /// <inheritdoc cref="PoseOf"/>
        public RigidTransform WorldOf(int workpiece, double seconds)
        {
            var passed = SinceTaken(workpiece, seconds);
            return passed < _held ? ToolAt(seconds) * InTool : OnBelt(passed);
        }

        /// <summary>Returns points on the belt, from the fixture to where workpieces are taken, in the robot's base frame.</summary>
        public IEnumerable<RigidTransform> Belt()
        {
            const int points = 48;
            for (var i = 0; i <= points; i++)
            {
                var pose = _conveyor.At((double)i * Names.Count / points);
                yield return RigidTransform.FromXyzRpy(pose.X, pose.Y, pose.Z - Size / 2, 0, 0, 0);
            }
        }

        /// <summary>Gets the values of all signals.</summary>
        /// <param name="values">One per element of <see cref="Signals"/>, 0 or 1.</param>
        public void SignalsAt(double seconds, Span<double> values)
        {
            bool isClosed = false, isPresent = false;
            for (var i = 0; i < Names.Count; i++)
            {
                var passed = SinceTaken(i, seconds);
                isClosed |= passed < _held;
                isPresent |= StationAt(passed) >= Names.Count;
            }
            var inCycle = SinceTaken(0, seconds) % _motion.CycleSeconds - _held - _wait;
            var isRunning = inCycle >= 0 && inCycle < _conveyor.StepSeconds;
            (values[0], values[1], values[2]) = (isClosed ? 1 : 0, isRunning ? 1 : 0, isPresent ? 1 : 0);
        }

        // Each workpiece is taken in every third cycle. Before the first time, it is where earlier cycles would have brought it.
        double SinceTaken(int workpiece, double seconds)
        {
            var period = Names.Count * _motion.CycleSeconds;
            var since = Math.Max(seconds, 0) - _motion.GripSeconds - workpiece * _motion.CycleSeconds;
            return since - period * Math.Floor(since / period);
        }

        RigidTransform OnBelt(double sinceTaken) => _conveyor.At(StationAt(sinceTaken));

        double StationAt(double sinceTaken)
        {
            var onBelt = sinceTaken - _held - _wait;
            if (onBelt < 0) return 0;
            var steps = Math.Min(Math.Floor(onBelt / _motion.CycleSeconds), Names.Count - 1);
            return steps + _conveyor.StepAt(onBelt - steps * _motion.CycleSeconds);
        }

        RigidTransform ToolAt(double seconds)
        {
            var joints = new double[_robot.MovingJoints.Count];
            _motion.At(seconds, joints);
            var poses = new RigidTransform[_robot.Links.Count];
            new ForwardKinematics(_robot).Compute(joints, poses);
            return poses[_robot.IndexOfLink(_tool)];
        }
    }
}
