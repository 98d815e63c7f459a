using System;
using System.Linq;
using Nowpose.Kinematics;

namespace Nowpose.Motion
{
    /// <summary>
    /// Creates a cycle from a robot's limits: long swings of the first joint alternate with short dips of the other joints. At the end of each dip, the
    /// robot rests while a gripper closes or opens.
    /// </summary>
    static class DerivedWaypoints
    {
        // Distance to either side of a joint's middle position, in rad or m: enough for the first joint to reach full speed, and less for the other
        // joints, as in a real task. Tables and walls are unknown and not considered.
        const double Swing = 1.2;
        const double Dip = 0.5;
        const double Stroke = 0.1;

        // Maximum share of a joint's range, which leaves a margin at both ends.
        const double RangeShare = 0.4;

        // For each waypoint, the swing of the first joint and the dip of the other joints, relative to the distances above.
        static readonly (double Swing, double Dip)[] Cycle =
        {
            (0, 0), (-1, 0.3), (-1, 1), (-1, 1), (-1, 1), (-1, 0.3),
            (1, -0.2), (1, -1), (1, -1), (1, -1), (1, -0.2),
        };

        /// <summary>
        /// The gripper closes and opens in the middle of the rest with the largest dip. The robot waits for a workpiece at the beginning of this
        /// rest, with an open gripper: from there on, the belt must be at rest, and earlier it would have to run faster.
        /// </summary>
        public static readonly TaskMoves Task = new TaskMoves(approach: 2, grip: 3, lower: 6, release: 8);

        /// <summary>
        /// Duration of the rest before a grip or release, and of the rest after it, s: about the time that the youBot's fingers take. The rest before
        /// is necessary because the predicted pose of a fast arm settles only after samples at rest have arrived. Without it, a workpiece that
        /// changes its parent would move in the displayed gripper.
        /// </summary>
        public const double RestSeconds = 0.35;

        /// <summary>Returns whether the robot rests in the move that begins at a waypoint.</summary>
        public static bool IsRest(int waypoint) =>
            waypoint == Task.Grip - 1 || waypoint == Task.Grip || waypoint == Task.Release - 1 || waypoint == Task.Release;

        public static double[][] Of(RobotModel robot) =>
            Cycle.Select(point => Positions(robot, point.Swing, point.Dip)).ToArray();

        static double[] Positions(RobotModel robot, double swing, double dip)
        {
            var positions = new double[robot.MovingJoints.Count];
            var isFirst = true;
            foreach (var joint in robot.MovingJoints.Where(joint => joint.Mimic == null))
            {
                // Neighbouring joints dip in opposite directions, which keeps the tool near its place.
                var share = isFirst ? swing : joint.MovingIndex % 2 == 0 ? -dip : dip;
                positions[joint.MovingIndex] = Middle(joint.Limits) + share * Reach(joint, isFirst ? Swing : Dip);
                isFirst = false;
            }

            return positions;
        }

        // Returns the position nearest to zero that has a margin to both ends of the range, because the URDF was drawn in the zero pose.
        static double Middle(JointLimits limits)
        {
            if (double.IsInfinity(limits.Lower) || double.IsInfinity(limits.Upper))
                return limits.Clamp(0);
            var room = RangeShare * (limits.Upper - limits.Lower);
            return Math.Min(Math.Max(0, limits.Lower + room), limits.Upper - room);
        }

        static double Reach(RobotJoint joint, double angle)
        {
            var wanted = joint.Kind == JointKind.Prismatic ? Stroke : angle;
            return Math.Min(wanted, RangeShare * (joint.Limits.Upper - joint.Limits.Lower));
        }
    }
}
