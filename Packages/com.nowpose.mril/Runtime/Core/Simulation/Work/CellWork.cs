using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Protocol;

namespace Nowpose.Simulation.Work
{
    /// <summary>
    /// The work of robots that pick and place: a conveyor brings workpieces, each gripper takes one per cycle and puts it on a fixture, from
    /// which the conveyor brings it to the next robot. A function of time; immutable and thread-safe.
    /// </summary>
    /// <remarks>All robots are of the same kind and move at the same time. The world frame is the first robot's base frame.</remarks>
    sealed class CellWork
    {
        /// <summary>
        /// Name of the conveyor's stationary frame. Its origin is on the z axis of the first robot's base frame, at the height of the belt's surface
        /// where workpieces are picked up.
        /// </summary>
        public const string Conveyor = "conveyor";

        /// <summary>Name of the signal that is 1 while the belt moves.</summary>
        public const string BeltRunning = "belt_running";

        /// <summary>Maximum number of robots.</summary>
        public const int MaxRobots = 2;

        /// <summary>Edge length of a workpiece, a cube whose frame is in its centre, m.</summary>
        public const double Size = 0.03;

        /// <summary>Number of belt steps between two robots, and number of workpieces per robot.</summary>
        const int Steps = 3;

        /// <summary>Distance between the bases of two robots, as a multiple of the distance from a base to its grip position.</summary>
        const double RobotDistance = 3.2;

        /// <summary>
        /// Time for which the belt waits after a workpiece was put down, so that the gripper can move away, as a fraction of the time from release to
        /// the next grip.
        /// </summary>
        const double WaitShare = 0.25;

        /// <summary>Maximum duration of a belt step, as a fraction of the time from release to the next grip.</summary>
        const double StepShare = 0.65;

        readonly IGrippingMotion _motion;
        readonly WorkRobot[] _robots;
        readonly RigidTransform _toConveyor;
        readonly double _held, _wait;

        /// <param name="robots">Number of robots, 1 to <see cref="MaxRobots"/>.</param>
        public CellWork(RobotModel robot, IGrippingMotion motion, int robots = 1)
        {
            _motion = motion;
            _robots = Enumerable.Range(0, robots).Select(i => new WorkRobot(robot, motion, i, robots, RobotDistance)).ToArray();
            _held = motion.ReleaseSeconds - motion.GripSeconds;
            var between = motion.CycleSeconds - _held;
            _wait = WaitShare * between;
            for (var i = 0; i < robots; i++)
                _robots[i].Belt = new Belt(_robots[i].Placed, _robots[(i + 1) % robots].Taken, Steps, StepShare * between, isRing: robots == 1);
            ConveyorPose = RigidTransform.FromXyzRpy(0, 0, _robots[0].Taken.Z - Size / 2, 0, 0, 0);
            _toConveyor = ConveyorPose.Inverse;
            Names = Enumerable.Range(1, Steps * robots).Select(i => "workpiece_" + i).ToArray();
            Signals = _robots.Select(each => each.GripperClosed).Append(BeltRunning).Concat(_robots.Select(each => each.PartPresent)).ToArray();
        }

        /// <summary>Names of the workpieces' frames.</summary>
        public IReadOnlyList<string> Names { get; }

        /// <summary>Names of the signals, in the order of <see cref="SignalsAt"/>.</summary>
        public IReadOnlyList<string> Signals { get; }

        public IReadOnlyList<WorkRobot> Robots => _robots;

        /// <summary>Pose of <see cref="Conveyor"/> in the world.</summary>
        public RigidTransform ConveyorPose { get; }

        /// <summary>Returns the pose of a workpiece in its parent, and the parent's name.</summary>
        /// <param name="seconds">Time since the start of the robots' motion, s.</param>
        public RigidTransform PoseOf(int workpiece, double seconds, out string parent)
        {
            var robot = _robots[RobotOf(workpiece, seconds, out var passed)];
            parent = passed < _held ? robot.Tool : passed < _held + _wait / 2 ? robot.Fixture : Conveyor;
            if (passed < _held) return robot.InTool;
            return (parent == Conveyor ? _toConveyor : robot.FixturePose.Inverse) * OnBelt(robot, passed);
        }

        /// <summary>Returns the pose of a workpiece in the world.</summary>
        /// <inheritdoc cref="PoseOf"/>
        public RigidTransform WorldOf(int workpiece, double seconds)
        {
            var robot = _robots[RobotOf(workpiece, seconds, out var passed)];
            return passed < _held ? robot.Base * robot.ToolAt(seconds) * robot.InTool : OnBelt(robot, passed);
        }

        /// <summary>Returns points on the upper side of the belt from a robot to the next robot, in the world.</summary>
        public IEnumerable<RigidTransform> BeltBehind(int robot)
        {
            const int points = 48;
            for (var i = 0; i <= points; i++)
            {
                var pose = _robots[robot].Belt.At((double)i * Steps / points);
                yield return RigidTransform.FromXyzRpy(pose.X, pose.Y, pose.Z - Size / 2, 0, 0, 0);
            }
        }

        /// <summary>Gets the values of all signals.</summary>
        /// <param name="values">Receives one value per element of <see cref="Signals"/>, 0 or 1.</param>
        public void SignalsAt(double seconds, Span<double> values)
        {
            values.Clear();
            for (var i = 0; i < Names.Count; i++)
            {
                var robot = RobotOf(i, seconds, out var passed);
                if (passed < _held) values[robot] = 1;
                // At the end of the belt, the workpiece waits for the next robot.
                if (StationAt(_robots[robot], passed) >= Steps) values[_robots.Length + 1 + (robot + 1) % _robots.Length] = 1;
                var inStep = passed % _motion.CycleSeconds - _held - _wait;
                if (inStep >= 0 && inStep < _robots[robot].Belt.StepSeconds) values[_robots.Length] = 1;
            }
        }

        // Returns the robot that has the workpiece or last had it. A workpiece moves on to the next robot after three cycles. Before its first
        // cycle, it is where earlier cycles would have left it.
        int RobotOf(int workpiece, double seconds, out double sinceTaken)
        {
            var period = Names.Count * _motion.CycleSeconds;
            var since = Math.Max(seconds, 0) - _motion.GripSeconds - workpiece * _motion.CycleSeconds;
            since -= period * Math.Floor(since / period);
            var robot = Math.Min((int)(since / (Steps * _motion.CycleSeconds)), _robots.Length - 1);
            sinceTaken = since - robot * Steps * _motion.CycleSeconds;
            return robot;
        }

        RigidTransform OnBelt(WorkRobot robot, double sinceTaken) => robot.Belt.At(StationAt(robot, sinceTaken));

        double StationAt(WorkRobot robot, double sinceTaken)
        {
            var onBelt = sinceTaken - _held - _wait;
            if (onBelt < 0) return 0;
            var steps = Math.Min(Math.Floor(onBelt / _motion.CycleSeconds), Steps - 1);
            return steps + robot.Belt.StepAt(onBelt - steps * _motion.CycleSeconds);
        }
    }
}
