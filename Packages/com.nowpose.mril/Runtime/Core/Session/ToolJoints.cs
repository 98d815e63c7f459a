using System.Collections.Generic;
using Nowpose.Kinematics;

namespace Nowpose.Session
{
    /// <summary>
    /// Finds the joints between base and tool that have their own samples. Only these joints decide whether the pose is current: a gripper
    /// that sends samples only while it moves must not make the arm stale.
    /// </summary>
    static class ToolJoints
    {
        /// <summary>
        /// Returns the indices of the joints between base and tool among the moving joints, starting at the base. A mimic joint is replaced by the
        /// joint with samples at the end of its chain.
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
