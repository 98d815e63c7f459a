using System;
using System.Linq;
using Nowpose.Tests.Core.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Nowpose.Tests.Unity.Robot
{
    /// <summary>Tests how a rig applies joint positions to a hierarchy, and which hierarchies it rejects.</summary>
    public class RobotRigTests
    {
        readonly SceneObjects _scene = new SceneObjects();

        [TearDown]
        public void Clean() => _scene.Destroy();

        RobotRig NewRig() => _scene.New<RobotRig>("Robot");

        [TestCase("youbot")]
        [TestCase("odd_axes")]
        public void Apply_HierarchyOfTheScene_MatchesForwardKinematics(string robot)
        {
            var model = UrdfFiles.Robot(robot);
            var rig = NewRig();
            var links = _scene.Links(model, rig.transform);
            rig.Bind(model);
            var positions = RobotPoses.Any(model, new Random(7));

            rig.Apply(positions);

            RobotPoses.RequireAgreement(rig, positions, robot);
            foreach (var link in links) Assert.That(rig.Link(link.Key), Is.SameAs(link.Value));
            Assert.That(rig.transform.childCount, Is.EqualTo(1), "the rig built no second robot");
        }

        [Test]
        public void Apply_MimicJoints_UseTheGivenPositions()
        {
            var rig = NewRig();
            rig.Bind(UrdfFiles.Robot("youbot"));
            var positions = new double[rig.Model.MovingJoints.Count];
            positions[rig.Model.IndexOfMovingJoint("gripper_finger_joint_l")] = 0.01;
            rig.Model.CompleteMimics(positions, new bool[positions.Length]);

            rig.Apply(positions);

            var opening = Vector3.Distance(rig.Link("gripper_finger_link_l").position, rig.Link("gripper_finger_link_r").position);
            Assert.That(opening, Is.EqualTo(0.016 + 2 * 0.01).Within(1e-6));
        }

        [TestCase("youbot", "tool_centre_point", "arm_link_5")]
        [TestCase("ur5", "tool0", "wrist_3_link")]
        public void Bind_Robot_SetsToolAndFlange(string robot, string tool, string flange)
        {
            var rig = NewRig();
            var bound = 0;
            rig.Bound += () => bound++;

            rig.Bind(UrdfFiles.Robot(robot));

            Assert.That(rig.Tool.name, Is.EqualTo(tool));
            Assert.That(rig.Flange.name, Is.EqualTo(flange));
            Assert.That(rig.Link("no such link"), Is.Null);
            Assert.That(bound, Is.EqualTo(1));
        }

        [Test]
        public void Bind_LinkMissing_NamesRobotLinkAndJoint()
        {
            var model = UrdfFiles.Robot("ur5");
            var rig = NewRig();
            UnityEngine.Object.DestroyImmediate(_scene.Links(model, rig.transform)["wrist_1_link"].gameObject);

            var fault = Assert.Throws<InputException>(() => rig.Bind(model));

            Assert.That(fault.Message, Does.Contain("'ur5'").And.Contain("'wrist_1_link'").And.Contain("'wrist_1_joint'").And.Contain("missing"));
            Assert.That(rig.Model, Is.Null);
            Assert.That(rig.Tool, Is.Null);
        }

        [Test]
        public void Bind_LinkBelowAnotherParent_Throws()
        {
            var model = UrdfFiles.Robot("ur5");
            var rig = NewRig();
            var links = _scene.Links(model, rig.transform);
            links["tool0"].SetParent(links["base_link"], false);

            var fault = Assert.Throws<InputException>(() => rig.Bind(model));

            Assert.That(fault.Message, Does.Contain("'tool0'").And.Contain("'wrist_3_link'").And.Contain("elsewhere"));
        }

        [TestCase("base_link")]
        [TestCase("forearm_link")]
        public void Bind_LinkIsScaled_Throws(string link)
        {
            var model = UrdfFiles.Robot("ur5");
            var rig = NewRig();
            _scene.Links(model, rig.transform)[link].localScale = new Vector3(1, 2, 1);

            var fault = Assert.Throws<InputException>(() => rig.Bind(model));

            Assert.That(fault.Message, Is.EqualTo(RigMessages.ScaledLink(model.Name, link)));
        }

        [Test]
        public void Bind_ScaledObjectAboveTheRootLink_Throws()
        {
            var model = UrdfFiles.Robot("ur5");
            var rig = NewRig();
            var group = _scene.New("model", rig.transform);
            group.localScale = Vector3.one * 0.001f;
            _scene.Links(model, group);

            var fault = Assert.Throws<InputException>(() => rig.Bind(model));

            Assert.That(fault.Message, Is.EqualTo(RigMessages.MovedBetween(model.Name, "model", rig.name, "base_link")));
        }

        [Test]
        public void Bind_RootLinkIsMoved_IsPlacedAtTheRig()
        {
            var model = UrdfFiles.Robot("ur5");
            var rig = NewRig();
            var root = _scene.Links(model, rig.transform)["base_link"];
            root.localPosition = new Vector3(0.1f, 0, 0);
            root.localRotation = Quaternion.Euler(0, 90, 0);

            rig.Bind(model);

            Assert.That((root.localPosition, root.localRotation), Is.EqualTo((Vector3.zero, Quaternion.identity)));
        }

        [Test]
        public void Bind_ScaledRig_IsAccepted()
        {
            var rig = NewRig();
            rig.transform.localScale = Vector3.one * 0.1f;

            Assert.DoesNotThrow(() => rig.Bind(UrdfFiles.Robot("ur5")));
        }

        [TestCase(0f, 0f, 1f, true)]
        [TestCase(1e-4f, 0f, 1f, false)]
        [TestCase(0f, 0.1f, 1f, false)]
        [TestCase(0f, 0f, 1.001f, false)]
        public void Bind_ObjectBetweenLinks_IsAcceptedOnlyWithoutOffset(float metres, float degrees, float scale, bool isAccepted)
        {
            var model = UrdfFiles.Robot("youbot");
            var rig = NewRig();
            var links = _scene.Links(model, rig.transform);
            var group = _scene.New("Virtual Gripper", links["arm_link_5"]);
            group.localPosition = new Vector3(0, metres, 0);
            group.localRotation = Quaternion.Euler(0, 0, degrees);
            group.localScale = new Vector3(1, scale, 1);
            links["gripper_palm_link"].SetParent(group, false);

            if (isAccepted) Assert.DoesNotThrow(() => rig.Bind(model));
            else Assert.That(Assert.Throws<InputException>(() => rig.Bind(model)).Message, Does.Contain("'Virtual Gripper'"));
        }

        [Test]
        public void Bind_HierarchyOfAnotherRobot_Throws()
        {
            var rig = NewRig();
            _scene.New<MeshFilter>("visual", _scene.Links(UrdfFiles.Robot("youbot"), rig.transform)["arm_link_2"]);

            var fault = Assert.Throws<InputException>(() => rig.Bind(UrdfFiles.Robot("ur5")));

            Assert.That(fault.Message, Does.Contain("'ur5'").And.Contain("'base_link'").And.Contain("'arm_link_0'"));
            Assert.That(rig.Model, Is.Null);
        }

        [Test]
        public void Bind_LinksOfAnotherRigBelow_AreIgnored()
        {
            var model = UrdfFiles.Robot("ur5");
            var rig = NewRig();
            var other = _scene.New<RobotRig>("Ghost", rig.transform);
            other.Bind(model);

            rig.Bind(model);

            Assert.That(rig.Link("base_link"), Is.Not.SameAs(other.Link("base_link")));
        }

        [Test]
        public void Apply_NotBound_Throws()
        {
            Assert.That(Assert.Throws<InvalidOperationException>(() => NewRig().Apply(new double[6])).Message, Does.Contain("'Robot'"));
        }

        [TestCase(5)]
        [TestCase(7)]
        public void Apply_WrongNumberOfJoints_Throws(int count)
        {
            var rig = NewRig();
            rig.Bind(UrdfFiles.Robot("ur5"));

            Assert.Throws<ArgumentException>(() => rig.Apply(new double[count]));
        }

        [Test]
        public void Bind_Null_IsRefused() => Assert.Throws<ArgumentNullException>(() => NewRig().Bind(null));
    }
}
