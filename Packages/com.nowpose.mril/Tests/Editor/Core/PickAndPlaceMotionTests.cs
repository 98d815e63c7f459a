using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class PickAndPlaceMotionTests
    {
        const double Step = 1e-3;

        // Limits of the arm. Finite differences of a profile with piecewise constant jerk are exact except for rounding.
        const double MaxAcceleration = 3;
        const double MaxJerk = 30;

        static double[][] Sampled(PickAndPlaceMotion motion)
        {
            var rows = new double[(int)(motion.CycleSeconds / Step) + 1][];
            for (var i = 0; i < rows.Length; i++)
                motion.At(i * Step, rows[i] = new double[motion.JointNames.Count]);
            return rows;
        }

        [TestCase("youbot")]
        [TestCase("ur5")]
        public void At_WholeCycle_StaysWithinEveryLimit(string name)
        {
            var robot = UrdfFiles.Robot(name);
            var rows = Sampled(new PickAndPlaceMotion(robot));

            foreach (var joint in robot.MovingJoints)
            {
                var q = rows.Select(row => row[joint.MovingIndex]).ToArray();
                var velocity = Differences(q);
                var acceleration = Differences(velocity);
                var jerk = Differences(acceleration);

                Assert.That(q, Is.Not.Empty.And.All.InRange(joint.Limits.Lower, joint.Limits.Upper), joint.Name);
                Assert.That(velocity.Max(Math.Abs), Is.LessThanOrEqualTo(joint.Limits.Velocity), joint.Name);
                Assert.That(acceleration.Max(Math.Abs), Is.LessThanOrEqualTo(MaxAcceleration * 1.001), joint.Name);
                Assert.That(jerk.Max(Math.Abs), Is.LessThanOrEqualTo(MaxJerk * 1.01), joint.Name);
            }
        }

        [Test]
        public void At_LongMove_NearlyReachesTheVelocityLimit()
        {
            var robot = UrdfFiles.Robot("youbot");
            var rows = Sampled(new PickAndPlaceMotion(robot));
            var base1 = robot.MovingJoints[robot.IndexOfMovingJoint("arm_joint_1")];

            var fastest = Differences(rows.Select(row => row[base1.MovingIndex]).ToArray()).Max(Math.Abs);

            Assert.That(fastest / base1.Limits.Velocity, Is.InRange(0.8, 1.0));
        }

        [Test]
        public void At_Youbot_GripperPointsStraightDownAtEachGrasp()
        {
            var robot = UrdfFiles.Robot("youbot");
            var motion = new PickAndPlaceMotion(robot);
            var poses = new RigidTransform[robot.Links.Count];
            var kinematics = new ForwardKinematics(robot);
            var finger = robot.IndexOfMovingJoint("gripper_finger_joint_l");
            var grips = new List<(double X, double Y, double Z)>();
            var before = default(double[]);

            // When the fingers close or open, the grasp point must be at the pick position or the place position.
            foreach (var row in Sampled(motion))
            {
                if (before != null && row[finger] != before[finger])
                {
                    kinematics.Compute(row, poses);
                    var tool = poses[robot.IndexOfLink("tool_centre_point")];
                    var palm = poses[robot.IndexOfLink("gripper_palm_link")];
                    grips.Add((tool.X, tool.Y, tool.Z));
                    Assert.That(palm.Z - tool.Z, Is.EqualTo(0.08).Within(1e-4), "the gripper points straight down");
                }

                before = row;
            }

            Assert.That(grips.Select(at => Math.Round(at.Z, 3)).Distinct(), Is.EquivalentTo(new[] { 0.010, 0.030 }));
            var reaches = grips.Select(at => Math.Round(Math.Sqrt(Math.Pow(at.X - 0.024, 2) + at.Y * at.Y), 2));
            Assert.That(reaches.Distinct(), Is.EquivalentTo(new[] { 0.22, 0.20 }));
        }

        [Test]
        public void At_MimicFinger_EqualsTheOtherFinger()
        {
            var robot = UrdfFiles.Robot("youbot");
            var left = robot.IndexOfMovingJoint("gripper_finger_joint_l");
            var right = robot.IndexOfMovingJoint("gripper_finger_joint_r");

            var rows = Sampled(new PickAndPlaceMotion(robot));

            Assert.That(rows.Select(row => row[right]), Is.EqualTo(rows.Select(row => row[left])));
            Assert.That(rows.Max(row => row[left]) - rows.Min(row => row[left]), Is.GreaterThan(0.005));
        }

        [Test]
        public void At_WholeCyclesLater_RepeatsThePosition()
        {
            var motion = new PickAndPlaceMotion(UrdfFiles.Robot("ur5"));
            var once = new double[6];
            var later = new double[6];
            for (var t = 0.05; t < motion.CycleSeconds; t += 0.1)
            {
                motion.At(t, once);
                motion.At(t + 7 * motion.CycleSeconds, later);

                Assert.That(later, Is.EqualTo(once).Within(1e-9));
            }
        }

        [Test]
        public void At_AllJoints_RestTogetherAtWaypointsOnly()
        {
            var rows = Sampled(new PickAndPlaceMotion(UrdfFiles.Robot("youbot")));
            var rests = 0;
            for (var i = 2; i < rows.Length; i++)
            {
                var fastest = rows[i].Zip(rows[i - 1], (a, b) => Math.Abs(a - b)).Max();
                var fastestBefore = rows[i - 1].Zip(rows[i - 2], (a, b) => Math.Abs(a - b)).Max();
                if (fastest > 1e-6 && fastestBefore <= 1e-6)
                    rests++;
            }

            Assert.That(rests, Is.EqualTo(9)); // one rest per move
        }

        // The fingers of the youBot begin to close when the arm has stopped. Other robots also rest before that.
        [TestCase("youbot", 0, 0.33)]
        [TestCase("ur5", 0.35, 0.35)]
        [TestCase("ur10e", 0.35, 0.35)]
        public void At_GripAndRelease_ArmRests(string name, double beforeSeconds, double afterSeconds)
        {
            var motion = new PickAndPlaceMotion(UrdfFiles.Robot(name));
            var arm = motion.JointNames.Count(joint => !joint.Contains("finger"));
            double[] rest = new double[motion.JointNames.Count], at = new double[motion.JointNames.Count];

            foreach (var grip in new[] { motion.StartOf(motion.Task.Grip), motion.StartOf(motion.Task.Release) })
            {
                motion.At(grip, rest);
                for (var t = grip - beforeSeconds + Step; t < grip + afterSeconds - Step; t += Step)
                {
                    motion.At(t, at);
                    Assert.That(at.Take(arm), Is.EqualTo(rest.Take(arm)).Within(1e-9), $"{t - grip} s after the grip or release at {grip} s");
                }
            }
        }

        [Test]
        public void Constructor_JointsWithoutRange_IsRefused()
        {
            var robot = UrdfReader.Read(
                "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/>"
                + "<axis xyz=\"0 0 1\"/><limit lower=\"0.5\" upper=\"0.5\" velocity=\"1\" effort=\"1\"/></joint></robot>", "r.urdf");

            Assert.Throws<InputException>(() => new PickAndPlaceMotion(robot));
        }

        [Test]
        public void Constructor_JointCannotReachAWaypoint_NamesTheJoint()
        {
            var text = UrdfFiles.Text("youbot.urdf").Replace("upper=\"5.8992\"", "upper=\"2\"");

            var error = Assert.Throws<InputException>(() => new PickAndPlaceMotion(UrdfReader.Read(text, "short.urdf")));

            Assert.That(error.Message, Does.Contain("arm_joint_1").And.Contain("2.9671"));
        }

        [Test]
        public void Constructor_RobotWithoutMovingJoint_IsRefused()
        {
            var robot = UrdfReader.Read("<robot name=\"r\"><link name=\"a\"/></robot>", "r.urdf");

            Assert.Throws<InputException>(() => new PickAndPlaceMotion(robot));
        }

        static double[] Differences(double[] values) =>
            values.Skip(1).Zip(values, (next, value) => (next - value) / Step).ToArray();
    }
}
