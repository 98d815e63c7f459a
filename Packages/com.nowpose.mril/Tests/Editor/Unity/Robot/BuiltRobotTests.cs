using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Tests.Core.Kinematics;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Nowpose.Tests.Unity.Robot
{
    /// <summary>Tests the robot that a rig builds if the scene contains no hierarchy for it.</summary>
    public class BuiltRobotTests
    {
        readonly SceneObjects _scene = new SceneObjects();

        [TearDown]
        public void Clean() => _scene.Destroy();

        RobotRig NewRig() => _scene.New<RobotRig>("Robot");

        [TestCase("youbot")]
        [TestCase("ur5")]
        [TestCase("odd_axes")]
        public void Apply_BuiltRig_MatchesForwardKinematics(string robot)
        {
            var rig = NewRig();
            rig.transform.SetPositionAndRotation(new Vector3(0.4f, -0.2f, 1.1f), Quaternion.Euler(10, 130, -20));
            rig.Bind(UrdfFiles.Robot(robot));
            for (var seed = 1; seed <= 100; seed++)
            {
                var positions = RobotPoses.Any(rig.Model, new Random(seed));

                rig.Apply(positions);

                RobotPoses.RequireAgreement(rig, positions, robot + ", seed " + seed);
            }
        }

        [Test]
        public void Bind_GripperAndLabelExist_BuildsTheRobotBesideThem()
        {
            var rig = NewRig();
            _scene.New("Label", rig.transform);
            _scene.New<MeshFilter>("visual", _scene.New<VirtualGripper>("Virtual Gripper", rig.transform).transform);

            rig.Bind(UrdfFiles.Robot("ur5"));

            Assert.That(rig.Tool, Is.Not.Null);
        }

        [Test]
        public void Bind_AnotherRobot_RemovesTheBuiltRobot()
        {
            var rig = NewRig();
            rig.Bind(UrdfFiles.Robot("ur5"));
            var old = rig.Link("base_link");

            rig.Bind(UrdfFiles.Robot("youbot"));

            Assert.That(old == null, Is.True);
            Assert.That(rig.transform.childCount, Is.EqualTo(1));
            Assert.That(rig.Model.Name, Is.EqualTo("youbot"));
            Assert.That(rig.Joints.Length, Is.EqualTo(7));
        }

        [Test]
        public void Bind_SameRobotAgain_KeepsTheBuiltRobot()
        {
            var model = UrdfFiles.Robot("ur5");
            var rig = NewRig();
            rig.Bind(model);
            var root = rig.Link("base_link");

            rig.Bind(model);

            Assert.That(rig.Link("base_link"), Is.SameAs(root));
        }

        [TestCase("youbot")]
        [TestCase("ur5")]
        public void Bind_NoHierarchy_GivesChildrenOfALinkUniqueNames(string robot)
        {
            var rig = NewRig();

            rig.Bind(UrdfFiles.Robot(robot));

            foreach (var link in rig.Model.Links)
            {
                var names = rig.Link(link.Name).Cast<Transform>().Select(child => child.name).ToArray();
                Assert.That(names, Is.Unique, link.Name);
            }
        }

        [Test]
        public void Bind_LinkNamedLikeAVisual_IsNotConfusedWithTheVisual()
        {
            var model = UrdfReader.Read(
                "<robot name='r'><link name='base'><visual><geometry><box size='1 1 1'/></geometry></visual></link><link name='visual'/>"
                + "<joint name='j' type='revolute'><parent link='base'/><child link='visual'/><origin xyz='0 0 2'/></joint></robot>", "r.urdf");
            var rig = NewRig();

            rig.Bind(model);

            Assert.That(rig.Link("visual").GetComponent<MeshFilter>() == null);
        }

        [Test]
        public void Bind_NoHierarchy_CreatesTheShapesOfTheLinks()
        {
            var (arm, tool) = (_scene.Material("arm"), _scene.Material("tool"));
            var rig = NewRig().With("_armMaterial", arm).With("_toolMaterial", tool);

            rig.Bind(UrdfFiles.Robot("youbot"));

            // The visual is a box of 0.19 × 0.13 × 0.024 m (forward, left, up). Its centre is 12 mm above the origin.
            var plate = rig.Link("arm_link_0").GetChild(0);
            Assert.That(plate.name, Is.EqualTo("visual"));
            Assert.That(Vector3.Distance(plate.localScale, new Vector3(0.13f, 0.024f, 0.19f)), Is.LessThan(1e-6));
            Assert.That(Vector3.Distance(plate.localPosition, new Vector3(0, 0.012f, 0)), Is.LessThan(1e-6));
            // The visual is a cylinder with a height of 72 mm. Unity's cylinder is 2 m high.
            var cylinder = rig.Link("arm_link_0").GetChild(1);
            Assert.That(Vector3.Distance(cylinder.localScale, new Vector3(0.12f, 0.036f, 0.12f)), Is.LessThan(1e-6));
            Assert.That(MaterialOf(rig, "arm_link_5"), Is.SameAs(arm));
            Assert.That(MaterialOf(rig, "gripper_palm_link"), Is.SameAs(tool));
            Assert.That(MaterialOf(rig, "gripper_finger_link_r"), Is.SameAs(tool));
            Assert.That(rig.GetComponentsInChildren<MeshFilter>().Select(filter => filter.sharedMesh), Is.Not.Empty.And.All.Not.Null);
        }

        [Test]
        public void Bind_MaterialMissing_UsesThePackagesShaderAndLeavesNoPrimitive()
        {
            var shader = UnityEditor.AssetDatabase.LoadAssetAtPath<Material>("Packages/com.nowpose.mril/Runtime/Materials/Hologram.mat").shader;
            var arm = _scene.Material("arm");
            var rig = NewRig().With("_armMaterial", arm);

            rig.Bind(UrdfFiles.Robot("youbot"));

            Assert.That(MaterialOf(rig, "arm_link_5"), Is.SameAs(arm));
            Assert.That(MaterialOf(rig, "gripper_palm_link").shader, Is.SameAs(shader));
            Assert.That(GameObject.Find("Cube"), Is.Null);
        }

        [Test]
        public void Bind_LinkOfMeshesOnly_IsDrawnAsBarsToItsJoints()
        {
            const string mesh = "<visual><geometry><mesh filename='package://a/b.dae'/></geometry></visual>";
            var model = UrdfFiles.Read("<link name='a'>" + mesh + "</link>" + UrdfFiles.Links("b", "c")
                + UrdfFiles.Joint("ab", "a", "b", "fixed", "<origin xyz='0 0 0.4'/>")
                + UrdfFiles.Joint("ac", "a", "c", "fixed", "<origin xyz='0.3 0 0'/>"));
            var rig = NewRig();

            rig.Bind(model);

            var bars = rig.GetComponentsInChildren<MeshRenderer>().Select(renderer => renderer.transform).ToArray();
            Assert.That(bars.Length, Is.EqualTo(2));
            foreach (var (bar, end) in bars.Zip(new[] { new Vector3(0, 0.4f, 0), new Vector3(0, 0, 0.3f) }, ValueTuple.Create))
            {
                Assert.That(Vector3.Distance(bar.TransformPoint(Vector3.up), end), Is.LessThan(1e-6), "the bar begins at the child");
                Assert.That(bar.TransformPoint(Vector3.down).magnitude, Is.LessThan(1e-6), "the bar ends at the parent");
            }
        }

        static Material MaterialOf(RobotRig rig, string link) => rig.Link(link).GetChild(0).GetComponent<MeshRenderer>().sharedMaterial;
    }
}
