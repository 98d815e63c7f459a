using System.Collections.Generic;
using Nowpose.Kinematics;

namespace Nowpose.Session
{
    /// <summary>
    /// Finds the joints between base and tool that have samples of their own. Only these decide whether the pose is current: a gripper that
    /// reports only its motion must not make the arm stale.
    /// </summary>
    static class ToolJoints
    {
        /// <summary>
        /// Returns their indices among the moving joints, from the base on. A mimic joint is replaced by the joint with samples at the end
        /// of its chain.
        /// </summary>
        public static int[] Of(RobotModel robot)
        {
            var joints = new List<int>();
            for (var link = robot.ToolLink; link.ParentIndex >= 0; link = robot.Links[link.ParentIndex])
            {
                var joint = link.ParentJoint;
                if (joint.MovingIndex < 0) continue;
                while (joint.Mimic != null) joint = robot.MovingJoints[robot.IndexOfMovingJoint(joint.Mimic.Master)];
                if (!joints.Contains(joint.MovingIndex)) joints.Add(joint.MovingIndex);
            }
            joints.Reverse();
            return joints.ToArray();
        }
    }
}
