using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class YoubotGripperTests
    {
        static double Opening(double finger)
        {
            var robot = UrdfFiles.Robot("youbot");
            var positions = new double[robot.MovingJoints.Count];
            var given = new bool[positions.Length];
            var left = robot.IndexOfMovingJoint("gripper_finger_joint_l");
            positions[left] = finger;
            given[left] = true;
            robot.CompleteMimics(positions, given);
            // All arm joints stay at 0, because the distance of the fingers does not depend on them.
            var poses = new RigidTransform[robot.Links.Count];
            new ForwardKinematics(robot).Compute(positions, poses);
            ref readonly var l = ref poses[robot.IndexOfLink("gripper_finger_link_l")];
            ref readonly var r = ref poses[robot.IndexOfLink("gripper_finger_link_r")];
            var (dx, dy, dz) = (l.X - r.X, l.Y - r.Y, l.Z - r.Z);
            return System.Math.Sqrt(dx * dx + dy * dy + dz * dz);
        }

        [TestCase(0, 0.016)]
        [TestCase(0.0115, 0.039)]
        public void Fingers_LeftFingerDriven_MoveSymmetrically(double finger, double expectedDistance)
        {
            Assert.That(Opening(finger), Is.EqualTo(expectedDistance).Within(1e-9));
        }
    }
}
