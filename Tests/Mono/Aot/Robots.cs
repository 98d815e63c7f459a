using System;
using Nowpose.Kinematics;
using Nowpose.Tests;
using Nowpose.Tests.Core.Kinematics;

namespace Nowpose.Mono.Aot
{
    static class Robots
    {
        public static void Check()
        {
            foreach (var name in new[] { "youbot", "ur5" })
            {
                var robot = UrdfFiles.Robot(name);
                var joints = new double[robot.MovingJoints.Count];
                var atZero = Tool(robot, joints);
                joints[0] = Math.PI / 2;
                var turned = Tool(robot, joints);

                Program.Require(joints.Length >= 5, name + " has " + joints.Length + " moving joints");
                Program.Require(Math.Abs(turned.Z - atZero.Z) < 1e-9, name + ": the first joint turns about the vertical");
                Program.Require(Math.Abs(turned.X - atZero.X) > 0.01, name + ": the first joint moves the tool");
            }
        }

        static RigidTransform Tool(RobotModel robot, double[] joints)
        {
            var poses = new RigidTransform[robot.Links.Count];
            new ForwardKinematics(robot).Compute(joints, poses);
            return poses[robot.IndexOfLink(robot.ToolLink.Name)];
        }
    }
}
