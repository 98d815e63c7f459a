using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Motion
{
    /// <summary>A robot that repeats a pick-and-place cycle, in jerk-limited moves from rest to rest.</summary>
    public sealed class PickAndPlaceMotion : IMotion
    {
        readonly RobotModel _robot;
        readonly JointMove[] _moves;
        readonly double[] _starts;
        readonly bool[] _given;

        /// <param name="robot">
        /// For the youBot, the cycle has waypoints of its own; for any other robot, it is derived from the robot's limits. Every robot rests while its
        /// gripper closes or opens.
        /// </param>
        /// <exception cref="InputException">The robot has no moving joints or too many, or cannot reach a waypoint.</exception>
        public PickAndPlaceMotion(RobotModel robot)
        {
            _robot = robot;
            JointNames = PlantJoints.NamesOf(robot);
            _given = robot.MovingJoints.Select(joint => joint.Mimic == null).ToArray();
            var isYoubot = YoubotWaypoints.Fits(robot);
            var waypoints = isYoubot ? YoubotWaypoints.Of(robot) : DerivedWaypoints.Of(robot);
            CheckReach(waypoints);
            var limits = robot.MovingJoints.Select(DriveLimits.Of).ToArray();
            _moves = waypoints.Zip(waypoints.Skip(1).Append(waypoints[0]), (from, to) => new JointMove(from, to, limits)).ToArray();
            if (_moves.All(move => move.Duration == 0))
                throw new InputException(RobotMessages.NoMovingJoint(robot.Name));
            Task = isYoubot ? YoubotWaypoints.Task : DerivedWaypoints.Task;
            _starts = new double[_moves.Length];
            for (var i = 0; i < _moves.Length; i++)
            {
                _starts[i] = CycleSeconds;
                CycleSeconds += isYoubot || !DerivedWaypoints.IsRest(i) ? _moves[i].Duration : DerivedWaypoints.RestSeconds;
            }
        }

        public IReadOnlyList<string> JointNames { get; }
        public double CycleSeconds { get; }

        internal TaskMoves Task { get; }

        /// <summary>Number of moves in a cycle.</summary>
        internal int MoveCount => _moves.Length;

        public void At(double seconds, Span<double> positions)
        {
            var inCycle = Math.Max(seconds, 0) % CycleSeconds;
            var move = _moves.Length - 1;
            while (inCycle < _starts[move])
                move--;
            At(move, inCycle - _starts[move], positions);
        }

        /// <summary>Computes the position of each joint in one move; allocates nothing.</summary>
        /// <param name="seconds">Time since the start of the move, s. After its end, the robot rests at the next waypoint.</param>
        /// <param name="positions">Receives one position per joint, rad or m.</param>
        internal void At(int move, double seconds, Span<double> positions)
        {
            _moves[move].At(seconds, positions);
            _robot.CompleteMimics(positions, _given);
        }

        /// <summary>Returns the time in the cycle at which a move starts, s.</summary>
        internal double StartOf(int move) => _starts[move];

        /// <summary>Returns the duration of a move, s. While a gripper closes or opens, the arm rests for the duration of the move.</summary>
        internal double SecondsOf(int move) => (move + 1 < _starts.Length ? _starts[move + 1] : CycleSeconds) - _starts[move];

        void CheckReach(double[][] waypoints)
        {
            for (var i = 0; i < waypoints.Length; i++)
            {
                _robot.CompleteMimics(waypoints[i], _given);
                foreach (var joint in _robot.MovingJoints)
                {
                    var position = waypoints[i][joint.MovingIndex];
                    var limits = joint.Limits;
                    if (!limits.Contains(position))
                        throw new InputException(RobotMessages.WaypointOutOfLimits(
                            _robot.Name, i + 1, joint.Name, position, joint.Kind == JointKind.Prismatic ? "m" : "rad", limits.Lower, limits.Upper));
                }
            }
        }
    }
}
