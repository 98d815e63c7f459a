using System;
using System.Collections.Generic;
using Nowpose.Kinematics;

namespace Nowpose.Session
{
    /// <summary>
    /// Finds the joints between base and tool, or another link, that have their own samples. Only the joints up to the tool decide whether the robot's pose
    /// is current: a gripper that sends samples only while it moves must not make the arm stale.
    /// </summary>
    static class ToolJoints
    {
        /// <summary>
        /// Returns the indices of the joints between base and tool among the moving joints, starting at the base. A mimic joint is replaced by the
        /// joint with samples at the end of its chain.
        /// </summary>
        public static int[] Of(RobotModel robot) => UpTo(robot.ToolLink, robot);

        /// <summary>
        /// Returns the joints that decide whether the pose of a link is current, as <see cref="Of"/> does. For the tool's own links, such as fingers, these are
        /// the joints up to the tool.
        /// </summary>
        /// <param name="link">Index of the link.</param>
        public static int[] OfLink(int link, RobotModel robot)
        {
            for (var above = robot.Links[link]; above.ParentIndex >= 0; above = robot.Links[above.ParentIndex])
                if (above == robot.ToolLink) return Of(robot);
            return UpTo(robot.Links[link], robot);
        }

        /// <summary>Returns the indices of the mimic joints between base and tool among the moving joints, starting at the base.</summary>
        public static int[] MimicsOf(RobotModel robot) => UpTo(robot.ToolLink, robot, joint => joint.Mimic == null ? null : joint);

        static int[] UpTo(RobotLink end, RobotModel robot) => UpTo(end, robot, robot.MasterOf);

        // select: returns the joint to list for a joint on the way; null for none.
        static int[] UpTo(RobotLink end, RobotModel robot, Func<RobotJoint, RobotJoint> select)
        {
            var joints = new List<int>();
            for (var link = end; link.ParentIndex >= 0; link = robot.Links[link.ParentIndex])
            {
                if (link.ParentJoint.MovingIndex < 0) continue;
                var joint = select(link.ParentJoint);
                if (joint != null && !joints.Contains(joint.MovingIndex)) joints.Add(joint.MovingIndex);
            }
            joints.Reverse();
            return joints.ToArray();
        }
    }
}
