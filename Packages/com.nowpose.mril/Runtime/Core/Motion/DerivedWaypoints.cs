using System;
using System.Linq;
using Nowpose.Kinematics;

namespace Nowpose.Motion
{
    /// <summary>A cycle for a robot of which only the limits are known: a long swing of the first joint between two small dips of the others.</summary>
    static class DerivedWaypoints
    {
        // rad and m to either side of a joint's middle: far enough for full speed, and the others less so that it looks like a
        // robot at work. Nothing is known of tables and walls.
        const double Swing = 1.2;
        const double Dip = 0.5;
        const double Stroke = 0.1;

        // At most this share of a joint's range, so that a little is left at both ends.
        const double RangeShare = 0.4;

        // Per waypoint: where the swing is, and whether the others dip.
        static readonly (double Swing, double Dip)[] Cycle =
        {
            (0, 0), (-1, 0.3), (-1, 1), (-1, 0.3), (1, -0.2), (1, -1), (1, -0.2),
        };

        public static double[][] Of(RobotModel robot) =>
            Cycle.Select(point => Positions(robot, point.Swing, point.Dip)).ToArray();

        static double[] Positions(RobotModel robot, double swing, double dip)
        {
            var positions = new double[robot.MovingJoints.Count];
            var isFirst = true;
            foreach (var joint in robot.MovingJoints.Where(joint => joint.Mimic == null))
            {
                // Neighbours dip against each other, which keeps the tool near where it was.
                var share = isFirst ? swing : joint.MovingIndex % 2 == 0 ? -dip : dip;
                positions[joint.MovingIndex] = Middle(joint.Limits) + share * Reach(joint, isFirst ? Swing : Dip);
                isFirst = false;
            }

            return positions;
        }

        // Zero where the joint can stand there: the pose its URDF was drawn in.
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
