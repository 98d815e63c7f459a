using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Session.Cell;
using Nowpose.Session.Hindcast;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    public class SessionRobotsTests
    {
        // The status panel reuses its statistics over all sessions.
        [Test]
        public void Statistics_ReusedForASessionWithOtherRobots_NameTheShownRobotsOfThatSession()
        {
            var statistics = new SessionStatistics();
            foreach (var name in new[] { "arm2", "arm3" })
            {
                var cell = new CellSession();
                var hidden = cell.Session.Robots.Add("hidden", TestRobot.Model);
                hidden.IsShown = false;
                cell.Session.Robots.Add(name, TestRobot.Model);

                statistics.Fill(cell.Session.Robots, HeadsetTime.FromSeconds(cell.Now));

                Assert.That(statistics.OtherRobots.Select(robot => robot.Namespace), Is.EqualTo(new[] { name }));
            }
        }

        // The tool error is measured in the robot's base. On a moving base, the displayed tool also has the error of the base.
        [TestCase(true)]
        [TestCase(false)]
        public void Statistics_RobotOnAFrame_HaveAToolErrorOnlyIfTheFrameIsStationary(bool isStationary)
        {
            var cell = new CellSession();
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0.3 * Math.Sin(2 * t), 0);
                var root = RigidTransform.FromXyzRpy(isStationary ? 1 : 0.15 * Math.Sin(5 * t), 0, 0, 0, 0, 0);
                cell.Send("world", cell.Session.Robots[0].Root, t, root, isStationary);
            };

            cell.Run(4);

            var statistics = cell.Session.Statistics(HeadsetTime.FromSeconds(cell.Now));
            Assert.That(statistics.ErrorMm.HasValue, Is.EqualTo(isStationary));
            Assert.That(statistics.ErrorWithheld, Is.EqualTo(isStationary ? ErrorWithheldReason.None : ErrorWithheldReason.MovingBase));
            Assert.That(statistics.JointErrors[0].Error.HasValue, Is.True, "the errors of the joints do not depend on the base");
        }

        [Test]
        public void Robots_EqualJointNames_AreSeparate()
        {
            var cell = new CellSession();
            var second = cell.Session.Robots.Add("arm2", TestRobot.Model);
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0.1 * (t - 20), 0);
                cell.SendJoints(t, -0.2 * (t - 20), 1, "arm2");
                cell.SendJoints(t, 3, 3, "another");
            };
            cell.Run(1);

            cell.Run(1, light =>
            {
                var main = cell.Session.Robots[0].Frame;
                Assert.That(main.Joints[0], Is.EqualTo(0.1 * (light - 20)).Within(1e-6));
                Assert.That(second.Frame.Joints[0], Is.EqualTo(-0.2 * (light - 20)).Within(1e-6));
                Assert.That(second.Frame.Joints[1], Is.EqualTo(1).Within(1e-6));
                Assert.That(second.Frame.DisplayTime, Is.EqualTo(main.DisplayTime), "the whole cell has one display time");
            });
        }

        [Test]
        public void Robot_WithoutSamples_IsIncompleteWhileTheOtherIsCurrent()
        {
            var cell = new CellSession();
            var second = cell.Session.Robots.Add("arm2", TestRobot.Model);
            cell.Sampling = t => cell.SendJoints(t, 0.5, 0.5);

            cell.Run(1);

            Assert.That(cell.Session.Robots[0].Frame.State, Is.EqualTo(PoseState.Current));
            Assert.That(second.Frame.State, Is.EqualTo(PoseState.Incomplete));
        }

        [Test]
        public void Session_WithNamespace_ReceivesOnlyItsRobot()
        {
            var cell = new CellSession(robotNamespace: "arm1");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0.3, 0, "arm1");
                cell.SendJoints(t, 0.9, 0);
            };

            cell.Run(1);

            Assert.That(cell.Session.Robots.Single().Frame.Joints[0], Is.EqualTo(0.3).Within(1e-9));
        }

        [Test]
        public void StatusReceived_QualifiedJoint_AppliesOnlyToItsRobot()
        {
            var cell = new CellSession();
            var second = cell.Session.Robots.Add("arm2", TestRobot.Model);
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                cell.SendJoints(t, 0, 0, "arm2");
            };
            cell.Session.Listener.StatusReceived(
                new JointStatusMessage(new[] { new JointReport("arm2/elbow", JointDataState.Fault, default, "") }), HeadsetTime.FromSeconds(20));

            cell.Run(1);

            Assert.That(cell.Session.Robots[0].Frame.State, Is.EqualTo(PoseState.Current));
            Assert.That(second.Frame.State, Is.EqualTo(PoseState.Held));
        }

        [Test]
        public void RootPose_RootLinkIsAFrame_FollowsTheFrame()
        {
            var cell = new CellSession();
            var second = cell.Session.Robots.Add("cart", TestRobot.Model);
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                cell.SendJoints(t, 0, 0, "cart");
                cell.Send("world", "cart/base", t, RigidTransform.FromXyzRpy(0.3 * t, 2, 0, 0, 0, 0));
            };
            cell.Run(1);

            cell.Run(1, light =>
            {
                Assert.That(cell.Session.Robots[0].RootPose.X, Is.Zero);
                Assert.That((second.RootPose.X, second.RootPose.Y), Is.EqualTo((0.3 * light, 2.0)).Using<(double, double)>(
                    (a, b) => Math.Abs(a.Item1 - b.Item1) < 1e-6 && Math.Abs(a.Item2 - b.Item2) < 1e-6 ? 0 : 1));
            });
        }

        // A robot at the last known place of its base would look right although the base has moved on.
        [Test]
        public void State_PosesOfTheMovingBaseEnd_IsHeld()
        {
            var cell = new CellSession();
            cell.Session.Robots.Add("cart", TestRobot.Model);
            var isBaseSent = true;
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                cell.SendJoints(t, 0, 0, "cart");
                if (!isBaseSent) return;
                foreach (var name in new[] { "base", "cart/base" }) cell.Send("world", name, t, RigidTransform.FromXyzRpy(0.3 * t, 2, 0, 0, 0, 0));
            };
            cell.Run(2);
            var before = cell.Session.Robots.Select(robot => robot.Frame.State).ToArray();

            isBaseSent = false;
            cell.Run(1);
            var stopped = cell.Session.Robots.Select(robot => robot.Frame.State).ToArray();
            isBaseSent = true;
            cell.Run(2);

            Assert.That(before, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(stopped, Is.Not.Empty.And.All.EqualTo(PoseState.Held));
            Assert.That(cell.Session.Robots.Select(robot => robot.Frame.State), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
        }

        [TestCase("")]
        [TestCase("1st")]
        [TestCase("arm 2")]
        [TestCase("an_arm_with_a_name_that_is_too_long")]
        public void Add_InvalidOrTakenNamespace_Throws(string name)
        {
            var session = new CellSession().Session;

            var refused = Assert.Throws<InputException>(() => session.Robots.Add(name, Other()));

            Assert.That(refused.Message, Does.StartWith("robot namespace").And.Contain("'" + name + "'"));
        }

        [Test]
        public void Add_SameRobotAgain_ReturnsTheExistingRobot()
        {
            var session = new CellSession().Session;

            Assert.That(session.Robots.Add("arm2", TestRobot.Model), Is.SameAs(session.Robots.Add("arm2", TestRobot.Model)));
        }

        [Test]
        public void Add_MoreNamespacesThanAllowed_Throws([Values("", "arm0")] string main)
        {
            var robots = new CellSession(robotNamespace: main).Session.Robots;
            for (var i = 1; i < ProtocolLimits.Robots + (main == "" ? 1 : 0); i++) robots.Add("arm" + i, TestRobot.Model);

            Assert.Throws<InputException>(() => robots.Add("one_more", TestRobot.Model));
            Assert.That(robots.Add("", TestRobot.Model).Namespace, Is.Empty);
            Assert.That(robots.Count, Is.EqualTo(ProtocolLimits.Robots + 1));
        }

        [TestCase("1st")]
        [TestCase("a/b")]
        public void Settings_InvalidNamespace_Throw(string name) =>
            Assert.That(
                () => new CellSession(robotNamespace: name),
                Throws.TypeOf<InputException>().With.Message.Contains("'" + name + "'").And.Message.Contains("32"));

        [TestCase("", new[] { "arm1", "arm2" }, true)]
        [TestCase("arm3", new[] { "arm1", "arm2" }, true)]
        [TestCase("arm2", new[] { "arm1", "arm2" }, false)]
        [TestCase("", new string[0], false)]
        public void Statistics_NoSamples_NameTheServedNamespacesUnlessTheyIncludeTheRobot(string robotNamespace, string[] served, bool areOthers)
        {
            var cell = new CellSession(robotNamespace: robotNamespace);
            var expected = areOthers ? RobotMessages.OtherNamespaces(robotNamespace, served) : null;
            string Now() => cell.Session.Statistics(HeadsetTime.FromSeconds(cell.Now)).OwnRobot.OtherNamespaces;
            cell.Run(0.1);
            var message = cell.Session.Listener.Diagnostics().Message;
            var isNeeded = cell.Session.Listener.NeedsNamespaces;

            cell.Session.Listener.NamespacesReceived(served);
            var without = Now();
            var reported = cell.Session.Listener.Diagnostics().Message;
            cell.Reconnect();
            var reconnected = Now();
            cell.Session.Listener.NamespacesReceived(served);
            cell.Sampling = t => cell.SendJoints(t, 0, 0, robotNamespace);
            cell.Run(1);
            cell.Session.Listener.Diagnostics();

            Assert.That((without, reconnected, Now()), Is.EqualTo((expected, (string)null, (string)null)));
            Assert.That(reported, Is.EqualTo(areOthers ? message + "; " + expected : message));
            Assert.That((isNeeded, cell.Session.Listener.NeedsNamespaces), Is.EqualTo((true, false)));
        }

        static RobotModel Other() => UrdfReader.Read("<robot name='other'><link name='base'/></robot>", "test");

        [Test]
        public void Diagnostics_SecondRobotWithFaults_NameItsPoseJointsAndDescription()
        {
            var cell = new CellSession();
            cell.Session.Robots.Add("arm2", TestRobot.Model);
            cell.Sampling = t => cell.SendJoints(t, 0, 0);
            cell.Run(1);
            string[] Of(params string[] keys) => keys.Select(key => DiagnosticsOf(cell).Values.FirstOrDefault(pair => pair.Key == key).Value).ToArray();

            Assert.That(Of("pose", "current_share", "missing_joints", "joint_status/arm2/elbow", "beyond_limits"),
                Is.EqualTo(new[] { "incomplete", "0", "arm2/shoulder,arm2/elbow", "no value", null }));
            Assert.That((DiagnosticsOf(cell).Level, cell.Session.ReadWorstPose(HeadsetTime.FromSeconds(cell.Now))), Is.EqualTo((2, PoseState.Incomplete)));
            Assert.That(cell.Session.Statistics(HeadsetTime.FromSeconds(cell.Now)).Pose, Is.EqualTo(PoseState.Current), "the session's own robot");

            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                cell.SendJoints(t, 45, 0, "arm2");
            };
            cell.Session.Listener.Described(OtherUrdf, "arm2");
            cell.Run(1);

            Assert.That(Of("pose", "missing_joints", "beyond_limits", "description_differs"),
                Is.EqualTo(new[] { "current", "", "arm2/shoulder", "arm2" }));
            Assert.That(DiagnosticsOf(cell).Level, Is.EqualTo(1));
        }

        // /nowpose/displayed and the diagnostics are common to all robots of the cell.
        [Test]
        public void Diagnostics_OwnRobotInANamespace_NameItsJointsWithTheNamespace()
        {
            var cell = new CellSession(robotNamespace: "arm2");
            string Of(string key) => DiagnosticsOf(cell).Values.FirstOrDefault(pair => pair.Key == key).Value;
            cell.Run(0.5);
            Assert.That((Of("missing_joints"), Of("joint_status/arm2/elbow")), Is.EqualTo(("arm2/shoulder,arm2/elbow", "no value")));

            cell.Sampling = t => cell.SendJoints(t, 45, 0, "arm2");
            cell.Session.Listener.Described(OtherUrdf, "arm2");
            cell.Run(4);

            Assert.That((Of("missing_joints"), Of("beyond_limits"), Of("description_differs")), Is.EqualTo(("", "arm2/shoulder", "arm2")));
            Assert.That(DiagnosticsOf(cell).Values.Where(pair => pair.Key.StartsWith("error/")).Select(pair => pair.Key),
                Is.All.StartsWith("error/arm2/").And.Not.Empty);
            Assert.That(cell.Session.Displayed().Names, Is.EqualTo(TestRobot.Model.MovingJoints.Select(joint => "arm2/" + joint.Name)));
        }

        const string OtherUrdf = "<robot name='other'><link name='base'/></robot>";

        static DiagnosticsMessage DiagnosticsOf(CellSession cell) =>
            SessionDiagnostics.Of(cell.Session.Statistics(HeadsetTime.FromSeconds(cell.Now)), CellFaults.None, "left", default);
    }
}
