using System.Collections.Generic;
using Nowpose.Tests.Core.Kinematics;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity.Robot
{
    public class VirtualGripperTests
    {
        const string Left = "gripper_finger_joint_l", Right = "gripper_finger_joint_r";

        readonly SceneObjects _scene = new SceneObjects();
        RobotRig _rig;
        VirtualGripper _gripper;
        Transform _left, _right;

        [SetUp]
        public void MakeGripper()
        {
            _rig = _scene.New<RobotRig>("Robot");
            _rig.transform.SetPositionAndRotation(new Vector3(1, 2, 3), Quaternion.Euler(0, 40, 0));
            _gripper = _scene.New<VirtualGripper>("Virtual Gripper");
            // As on the youBot's palm, the left finger is turned by 180°, so each finger opens along its own axis.
            _left = Finger("Left", new Vector3(-0.008f, 0.046f, 0.004f), 180);
            _right = Finger("Right", new Vector3(0.008f, 0.046f, 0.004f), 0);
            _gripper.With("_fingers", new List<GripperFinger> { new GripperFinger(Left, _left), new GripperFinger(Right, _right) });
        }

        [TearDown]
        public void Clean() => _scene.Destroy();

        Transform Finger(string name, Vector3 position, float degrees)
        {
            var finger = _scene.New(name, _gripper.transform);
            finger.localPosition = position;
            finger.localRotation = Quaternion.Euler(0, degrees, 0);
            return finger;
        }

        void Open(double metres)
        {
            var positions = new double[_rig.Model.MovingJoints.Count];
            for (var i = 0; i < positions.Length; i++) positions[i] = 0.3 + 0.1 * i;
            if (_rig.Model.IndexOfMovingJoint(Left) is var left && left >= 0) positions[left] = metres;
            _rig.Model.CompleteMimics(positions, new bool[positions.Length]);
            _rig.Apply(positions);
        }

        [TestCase(0, 0.016)]
        [TestCase(0.005, 0.026)]
        [TestCase(0.0115, 0.039)]
        public void Posed_FingerJointMoves_OpensBothFingers(double metres, double opening)
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            _gripper.Mount(_rig);

            Open(metres);

            Assert.That(Vector3.Distance(_left.position, _right.position), Is.EqualTo(opening).Within(1e-6));
        }

        [Test]
        public void Posed_OpenedAndClosed_ReturnsToTheStart()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            _gripper.Mount(_rig);
            var rest = _left.localPosition;

            Open(0.0115);
            Assert.That(Vector3.Distance(_left.localPosition, rest), Is.EqualTo(0.0115).Within(1e-6));
            Open(0);

            Assert.That(_left.localPosition, Is.EqualTo(rest));
        }

        [Test]
        public void Posed_NotBelowTheFlange_FollowsTheFlange()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            _gripper.Mount(_rig);

            Open(0);

            Assert.That(_gripper.Flange, Is.SameAs(_rig.Link("arm_link_5")));
            Assert.That(Vector3.Distance(_gripper.transform.position, _rig.Flange.position), Is.LessThan(1e-6));
            Assert.That(Quaternion.Angle(_gripper.transform.rotation, _rig.Flange.rotation), Is.LessThan(0.05));
        }

        [Test]
        public void Posed_BelowTheFlange_KeepsItsLocalPosition()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            _gripper.transform.SetParent(_rig.Flange, false);
            _gripper.transform.localPosition = new Vector3(0, 0.02f, 0);
            _gripper.Mount(_rig);

            Open(0);

            Assert.That(_gripper.transform.localPosition, Is.EqualTo(new Vector3(0, 0.02f, 0)));
        }

        [Test]
        public void Posed_FlangeLinkNamed_FollowsTheNamedLink()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            _gripper.With("_flangeLink", "arm_link_4").Mount(_rig);

            Open(0);

            Assert.That(Vector3.Distance(_gripper.transform.position, _rig.Link("arm_link_4").position), Is.LessThan(1e-6));
        }

        [Test]
        public void Bound_RobotWithoutTheJoints_FingersReturnToRest()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            _gripper.Mount(_rig);
            var rest = _right.localPosition;
            Open(0.0115);

            _rig.Bind(UrdfFiles.Robot("ur5"));
            Open(0.0115);

            Assert.That(_right.localPosition, Is.EqualTo(rest));
            Assert.That(Vector3.Distance(_gripper.transform.position, _rig.Link("wrist_3_link").position), Is.LessThan(1e-6));
        }

        [Test]
        public void Posed_FingersAreLinksOfTheRig_AreNotMoved()
        {
            var model = UrdfFiles.Robot("youbot");
            var links = _scene.Links(model, _rig.transform);
            _gripper.With("_fingers", new List<GripperFinger> { new GripperFinger(Left, links["gripper_finger_link_l"]) });
            _rig.Bind(model);
            _gripper.Mount(_rig);
            var positions = RobotPoses.Any(model, new System.Random(3));

            _rig.Apply(positions);

            RobotPoses.RequireAgreement(_rig, positions, "the rig alone moves the links");
        }

        [Test]
        public void Unmount_Mounted_KeepsItsPosition()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            _gripper.Mount(_rig);
            Open(0);
            var place = _gripper.transform.position;

            _gripper.Unmount();
            _rig.Apply(new double[7]);

            Assert.That(_gripper.transform.position, Is.EqualTo(place));
            Assert.That(_gripper.Rig, Is.Null);
        }

        [Test]
        public void Unmount_FingersOpen_ReturnsThemToRest()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            var rest = _left.localPosition;
            _gripper.Mount(_rig);
            Open(0.0115);

            _gripper.Unmount();
            Assert.That(_left.localPosition, Is.EqualTo(rest));

            // When Unity recompiles scripts in play mode, it recreates the fingers in this way.
            _gripper.With("_fingers", new List<GripperFinger> { new GripperFinger(Left, _left), new GripperFinger(Right, _right) });
            _gripper.Mount(_rig);
            Open(0.0115);
            Open(0);

            Assert.That(_left.localPosition, Is.EqualTo(rest));
        }

        [Test]
        public void Unmount_FingerDestroyed_ResetsTheOtherFinger()
        {
            _rig.Bind(UrdfFiles.Robot("youbot"));
            var rest = _right.localPosition;
            _gripper.Mount(_rig);
            Open(0.0115);
            Object.DestroyImmediate(_left.gameObject);

            _gripper.Unmount();

            Assert.That(_right.localPosition, Is.EqualTo(rest));
        }
    }
}
