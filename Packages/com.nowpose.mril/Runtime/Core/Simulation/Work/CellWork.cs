using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>
    /// The work of robots that pick and place: a conveyor brings workpieces, each gripper takes one per cycle and puts it on a fixture, from
    /// which the conveyor brings it to the next robot. A control program with a cycle of 1 ms controls belt, grippers and moves.
    /// </summary>
    /// <remarks>
    /// All robots are of the same kind; each has its own program. The world frame is the first robot's base frame. Times may be read in any order. A
    /// read at a later time than all others first runs the program until then, at 0.1 to 0.2 µs for each cycle, and allocates the states of the
    /// changes. Only the changes of the last <see cref="KeptSeconds"/> are kept, in about 5 MB for each robot; an earlier time gives the oldest kept
    /// state. Deterministic and thread-safe.
    /// </remarks>
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

        /// <summary>Minimum time for which changes are kept, s: longer than a demo, whose frames are compared with the cell after its end.</summary>
        const double KeptSeconds = 7200;

        readonly CellLayout _layout;
        readonly CellProgram _program;
        // The states in the order of their cycles.
        readonly List<CellState> _changes = new List<CellState>();
        readonly double _keptSeconds;
        long _cycle = -1;

        /// <param name="motion">The moves of each robot.</param>
        /// <param name="robots">Number of robots, 1 to <see cref="MaxRobots"/>.</param>
        /// <param name="keptSeconds">Minimum time for which changes are kept, s.</param>
        public CellWork(RobotModel robot, PickAndPlaceMotion motion, int robots = 1, double keptSeconds = KeptSeconds)
        {
            _keptSeconds = keptSeconds;
            _layout = new CellLayout(robot, motion, robots);
            Plant = new CellPlant(_layout);
            _program = new CellProgram(motion.Task, motion.MoveCount, robots);
            Motions = Robots.Select((robot, i) => (robot.Namespace, (IMotion)new RobotMotion(this, i))).ToArray();
            CycleSeconds = CellState.CycleSeconds * Enumerable.Range(0, motion.MoveCount).Sum(move => CellPlant.CyclesOfMove(motion, move));
        }

        /// <summary>The true motion of each robot, with the robot's namespace.</summary>
        public IReadOnlyList<(string Namespace, IMotion Motion)> Motions { get; }

        /// <summary>Period of the robots if nothing delays them, s. Each move starts in the first control cycle after the end of the last.</summary>
        public double CycleSeconds { get; }

        /// <summary>Names of the workpieces' frames.</summary>
        public IReadOnlyList<string> Names => _layout.Names;

        /// <summary>Names of the signals, in the order of <see cref="SignalsAt"/>.</summary>
        public IReadOnlyList<string> Signals => _layout.Signals;

        public IReadOnlyList<WorkRobot> Robots => _layout.Robots;

        /// <summary>Pose of <see cref="Conveyor"/> in the world.</summary>
        public RigidTransform ConveyorPose => _layout.ConveyorPose;

        /// <summary>The parts that the program controls. Disturb them only while no other thread reads; the past does not change.</summary>
        public CellPlant Plant { get; }

        /// <summary>Returns the pose of a workpiece in its parent, and the parent's name.</summary>
        /// <param name="seconds">Time since the start, s.</param>
        public RigidTransform PoseOf(int workpiece, double seconds, out string parent) => StateAt(seconds).PoseOf(workpiece, seconds, out parent);

        /// <summary>Returns the pose of a workpiece in the world.</summary>
        /// <inheritdoc cref="PoseOf"/>
        public RigidTransform WorldOf(int workpiece, double seconds) => StateAt(seconds).WorldOf(workpiece, seconds);

        /// <summary>Returns points on the upper side of the belt from a robot to the next robot, in the world.</summary>
        public IEnumerable<RigidTransform> BeltBehind(int robot)
        {
            const int points = 48;
            for (var i = 0; i <= points; i++)
            {
                var pose = _layout.Robots[robot].Belt.At((double)i * CellLayout.Stations / points);
                yield return RigidTransform.FromXyzRpy(pose.X, pose.Y, pose.Z - Size / 2, 0, 0, 0);
            }
        }

        /// <summary>Gets the values of all signals.</summary>
        /// <param name="values">Receives one value per element of <see cref="Signals"/>, 0 or 1.</param>
        /// <inheritdoc cref="PoseOf"/>
        public void SignalsAt(double seconds, Span<double> values) => StateAt(seconds).GetSignals(values);

        /// <summary>Gets the state at a time.</summary>
        /// <inheritdoc cref="PoseOf"/>
        public CellState StateAt(double seconds)
        {
            var cycle = CycleAt(seconds);
            lock (_changes)
            {
                RunUntil(cycle);
                return _changes[Math.Max(0, CountUntil(cycle) - 1)];
            }
        }

        /// <summary>Returns the first state after a state and not after a time; null if the cell has not changed in between.</summary>
        /// <inheritdoc cref="PoseOf"/>
        public CellState Next(CellState state, double seconds)
        {
            var cycle = CycleAt(seconds);
            lock (_changes)
            {
                RunUntil(cycle);
                var next = CountUntil(state.Cycle);
                return next < _changes.Count && _changes[next].Cycle <= cycle ? _changes[next] : null;
            }
        }

        // A time that is meant to be that of a cycle may be smaller because of rounding.
        static long CycleAt(double seconds) => (long)Math.Floor(Math.Max(0, seconds) / CellState.CycleSeconds + 1e-6);

        void RunUntil(long cycle)
        {
            while (_cycle < cycle)
            {
                Plant.Follow(_program.Run(Plant.Sense(++_cycle)));
                if (_changes.Count == 0 || _changes[_changes.Count - 1] != Plant.State) _changes.Add(Plant.State);
                // Removes one half at a time, so that a change seldom moves the list.
                var half = _changes.Count / 2;
                if ((_cycle - _changes[half].Cycle) * CellState.CycleSeconds > _keptSeconds) _changes.RemoveRange(0, half);
            }
        }

        // Returns the number of states that are valid from this cycle or an earlier one.
        int CountUntil(long cycle)
        {
            var (low, high) = (0, _changes.Count);
            while (low < high)
            {
                var middle = (low + high) / 2;
                if (_changes[middle].Cycle <= cycle) low = middle + 1;
                else high = middle;
            }
            return low;
        }

        sealed class RobotMotion : IMotion
        {
            readonly CellWork _work;
            readonly int _robot;

            public RobotMotion(CellWork work, int robot) => (_work, _robot) = (work, robot);

            public IReadOnlyList<string> JointNames => _work._layout.Motion.JointNames;
            public double CycleSeconds => _work.CycleSeconds;
            public void At(double seconds, Span<double> positions) => _work.StateAt(seconds).JointsAt(_robot, seconds, positions);
        }
    }
}
