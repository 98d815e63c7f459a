using System.Linq;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class UrdfReaderTests
    {
        static readonly string TwoLinks = UrdfFiles.Links("a", "b");

        static RobotJoint Joint(string type, string inside) =>
            UrdfFiles.Read(TwoLinks + UrdfFiles.Joint("j", "a", "b", type, inside)).Joints[0];

        [TestCase("fixed", JointKind.Fixed)]
        [TestCase("revolute", JointKind.Revolute)]
        [TestCase("continuous", JointKind.Continuous)]
        [TestCase("prismatic", JointKind.Prismatic)]
        public void Read_KnownJointType_ReturnsItsKind(string type, JointKind kind)
        {
            Assert.That(Joint(type, "").Kind, Is.EqualTo(kind));
        }

        [Test]
        public void Read_AxisMissing_ReturnsTheXAxis()
        {
            Assert.That(Joint("revolute", "").Axis, Is.EqualTo((1.0, 0.0, 0.0)));
        }

        [Test]
        public void Read_LongAxis_IsNormalised()
        {
            Assert.That(Joint("revolute", "<axis xyz='0 -3 4'/>").Axis, Is.EqualTo((0.0, -0.6, 0.8)));
        }

        [TestCase("0 0 0")]
        [TestCase("nonsense")]
        public void Read_AxisOfFixedJoint_IsIgnored(string xyz)
        {
            Assert.That(Joint("fixed", "<axis xyz='" + xyz + "'/>").Kind, Is.EqualTo(JointKind.Fixed));
        }

        [TestCase("", double.NegativeInfinity, double.PositiveInfinity, double.PositiveInfinity)]
        [TestCase("<limit velocity='2' effort='1'/>", double.NegativeInfinity, double.PositiveInfinity, 2)]
        [TestCase("<limit lower='-1' upper='.5' velocity='2'/>", -1, 0.5, 2)]
        [TestCase("<limit upper='1e-3'/>", 0, 1e-3, double.PositiveInfinity)]
        [TestCase("<limit lower='-1' upper='1' velocity='0'/>", -1, 1, double.PositiveInfinity)]
        public void Read_Limit_ReturnsItsValuesOrTheDefaults(string limit, double lower, double upper, double velocity)
        {
            var limits = Joint("revolute", limit).Limits;

            Assert.That(new[] { limits.Lower, limits.Upper, limits.Velocity }, Is.EqualTo(new[] { lower, upper, velocity }));
        }

        [Test]
        public void Read_LimitOfContinuousJoint_HasOnlyVelocityAndEffort()
        {
            var limits = Joint("continuous", "<limit lower='0' upper='0' velocity='3' effort='4'/>").Limits;

            Assert.That(limits.Contains(1000), Is.True);
            Assert.That((limits.Velocity, limits.Effort), Is.EqualTo((3.0, 4.0)));
        }

        [Test]
        public void Read_Visuals_KeepShapeSizeOriginAndColour()
        {
            var visuals = UrdfFiles.Read(
                "<material name='red'><color rgba='1 0 0 .5'/></material><link name='a'>"
                + "<visual><origin xyz='1 2 3'/><geometry><box size='1 2 3'/></geometry><material name='red'/></visual>"
                + "<visual><geometry><cylinder radius='0.5' length='3'/></geometry><material name='x'><color rgba='0 1 0'/></material></visual>"
                + "<visual><geometry><sphere radius='2'/></geometry></visual>"
                + "<visual><geometry><mesh filename='package://p/m.dae' scale='1 1 -1'/></geometry><material name='none'/></visual>"
                + "<visual><geometry><capsule radius='1' length='2'/></geometry></visual>"
                + "<collision><geometry><box size='9 9 9'/></geometry></collision></link>").Root.Visuals;

            Assert.That(visuals.Select(v => v.Shape), Is.EqualTo(new[]
            {
                VisualShape.Box, VisualShape.Cylinder, VisualShape.Sphere, VisualShape.Mesh,
            }));
            Assert.That(visuals.Select(v => v.Size), Is.EqualTo(new[] { (1.0, 2.0, 3.0), (1, 1, 3), (4, 4, 4), (1, 1, -1) }));
            Assert.That((visuals[0].Origin.X, visuals[0].Origin.Y, visuals[0].Origin.Z), Is.EqualTo((1.0, 2.0, 3.0)));
            Assert.That(visuals[0].Colour.Value.Alpha, Is.EqualTo(0.5));
            Assert.That(visuals[1].Colour.Value.Green, Is.EqualTo(1));
            Assert.That(visuals[2].Colour ?? visuals[3].Colour, Is.Null);
            Assert.That(visuals[3].MeshFile, Is.EqualTo("package://p/m.dae"));
        }

        [Test]
        public void Read_UnusedElements_AreIgnored()
        {
            var model = UrdfFiles.Read(TwoLinks + UrdfFiles.Joint("j", "a", "b", inside: "<dynamics damping='x'/><safety_controller/>")
                + "<gazebo reference='a'><material>Gazebo/Red</material><link/><joint name='j'/></gazebo>"
                + "<transmission name='t'><joint name='j'/></transmission>"
                + "<g:joint xmlns:g='http://gazebosim.org/g' name='other'/><!-- <joint/> --><?pi?>");

            Assert.That(model.Joints.Count, Is.EqualTo(1));
        }

        [Test]
        public void Read_DefaultNamespaceAndByteOrderMark_AreAccepted()
        {
            var model = UrdfReader.Read("\uFEFF<?xml version='1.0'?><robot xmlns='http://www.ros.org'><link name='a'/></robot>", "r.urdf");

            Assert.That(model.Root.Name, Is.EqualTo("a"));
            Assert.That(model.Name, Is.Empty);
        }

        [Test]
        public void Read_CultureWithDecimalComma_ReadsDecimalPoints()
        {
            using var culture = new DecimalComma();

            Assert.That(Joint("fixed", "<origin xyz='0.25 0 0'/>").Origin.X, Is.EqualTo(0.25));
        }

        [Test]
        public void Read_ChainOfManyThousandLinks_IsRead()
        {
            const int links = 20000;
            var text = string.Concat(Enumerable.Range(0, links).Select(i => "<link name='l" + i + "'/>"))
                + string.Concat(Enumerable.Range(1, links - 1).Select(i => UrdfFiles.Joint(
                    "j" + i, "l" + (i - 1), "l" + i, inside: i < links - 1 ? "<mimic joint='j" + (i + 1) + "'/>" : "")));

            Assert.That(UrdfFiles.Read(text).ToolLink.Name, Is.EqualTo("l19999"));
        }
    }
}
