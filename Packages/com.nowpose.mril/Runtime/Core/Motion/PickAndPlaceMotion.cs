using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Motion
{
    /// <summary>A robot that repeats a pick-and-place cycle, in jerk-limited moves from rest to rest.</summary>
    public sealed class PickAndPlaceMotion : IGrippingMotion
    {
        readonly RobotModel _robot;
        readonly JointMove[] _moves;
        readonly double[] _ends;
        readonly bool[] _given;
        readonly double _grip, _release;

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
            _ends = new double[_moves.Length];
            for (var i = 0; i < _moves.Length; i++)
                _ends[i] = CycleSeconds += isYoubot || !DerivedWaypoints.IsRest(i) ? _moves[i].Duration : DerivedWaypoints.RestSeconds;
            _grip = _ends[(isYoubot ? YoubotWaypoints.Grip : DerivedWaypoints.Grip) - 1];
            _release = _ends[(isYoubot ? YoubotWaypoints.Release : DerivedWaypoints.Release) - 1];
        }

        public IReadOnlyList<string> JointNames { get; }
        public double CycleSeconds { get; }
        double IGrippingMotion.GripSeconds => _grip;
        double IGrippingMotion.ReleaseSeconds => _release;

        public void At(double seconds, Span<double> positions)
        {
            var inCycle = Math.Max(seconds, 0) % CycleSeconds;
            var move = 0;
            while (move < _moves.Length - 1 && inCycle >= _ends[move])
                move++;
            _moves[move].At(inCycle - (move == 0 ? 0 : _ends[move - 1]), positions);
            _robot.CompleteMimics(positions, _given);
        }

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
