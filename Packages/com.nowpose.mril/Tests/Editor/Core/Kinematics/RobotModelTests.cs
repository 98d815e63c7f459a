using System.Linq;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class RobotModelTests
    {
        const string Arm = "<link name='base'/><link name='upper'/><link name='stub'/><link name='fore'/><link name='hand'/>";

        static readonly string Joints = UrdfFiles.Joint("elbow", "upper", "fore")
            + UrdfFiles.Joint("plate", "base", "stub", "fixed")
            + UrdfFiles.Joint("shoulder", "base", "upper", "continuous");

        [Test]
        public void Links_JointsInAnyOrder_ParentsComeFirst()
        {
            var model = UrdfFiles.Robot("odd_axes");

            Assert.That(model.Root.Name, Is.EqualTo("body"));
            Assert.That(model.Links.Skip(1).Select((link, i) => link.ParentIndex <= i), Is.All.True);
            foreach (var link in model.Links.Skip(1))
                Assert.That(model.Links[link.ParentIndex].Name, Is.EqualTo(link.ParentJoint.ParentLink));
        }

        [Test]
        public void MovingJoints_FixedJointsBetween_KeepTheOrderOfTheFile()
        {
            var model = UrdfFiles.Read(Arm + Joints + UrdfFiles.Joint("wrist", "fore", "hand"));

            Assert.That(model.MovingJoints.Select(joint => joint.Name), Is.EqualTo(new[] { "elbow", "shoulder", "wrist" }));
            Assert.That(model.IndexOfMovingJoint("shoulder"), Is.EqualTo(1));
            Assert.That(model.IndexOfMovingJoint("plate"), Is.EqualTo(-1));
            Assert.That(model.IndexOfLink("nothing"), Is.EqualTo(-1));
        }

        [TestCase("", "hand", TestName = "ToolLink_NoKnownName_IsTheLeafWithTheMostMovingJoints")]
        [TestCase("flange", "flange", TestName = "ToolLink_Flange_IsTheFlange")]
        [TestCase("flange tool0", "tool0", TestName = "ToolLink_FlangeAndTool0_IsTool0")]
        [TestCase("flange tool0 tool_centre_point", "tool_centre_point", TestName = "ToolLink_AllKnownNames_IsTheToolCentrePoint")]
        public void ToolLink_SeveralKnownFrameNames_IsTheFrameClosestToTheTool(string frames, string expected)
        {
            var extra = string.Concat(frames.Split(new[] { ' ' }, System.StringSplitOptions.RemoveEmptyEntries)
                .Select(name => UrdfFiles.Links(name) + UrdfFiles.Joint("to_" + name, "base", name, "fixed")));

            var model = UrdfFiles.Read(Arm + Joints + UrdfFiles.Joint("wrist", "fore", "hand", "fixed") + extra);

            Assert.That(model.ToolLink.Name, Is.EqualTo(expected));
        }

        [Test]
        public void ToolLink_LeavesOfEqualDepth_ReturnsTheFirstInTheFile()
        {
            var model = UrdfFiles.Read(UrdfFiles.Links("second", "base", "third")
                + UrdfFiles.Joint("a", "base", "third") + UrdfFiles.Joint("b", "base", "second"));

            Assert.That(model.ToolLink.Name, Is.EqualTo("second"));
        }

        [TestCase("youbot", "tool_centre_point", 7)]
        [TestCase("ur5", "tool0", 6)]
        public void ToolLink_RobotsOfThePackage_ReturnsTheirTool(string name, string tool, int moving)
        {
            var model = UrdfFiles.Robot(name);

            Assert.That(model.Name, Is.EqualTo(name));
            Assert.That(model.ToolLink.Name, Is.EqualTo(tool));
            Assert.That(model.MovingJoints.Count, Is.EqualTo(moving));
        }

        [TestCase("youbot", "arm_link_5")]
        [TestCase("ur5", "wrist_3_link")]
        public void FlangeLink_RobotsOfThePackage_ReturnsTheLastLinkOfTheArm(string name, string flange)
        {
            Assert.That(UrdfFiles.Robot(name).FlangeLink.Name, Is.EqualTo(flange));
        }

        [Test]
        public void FlangeLink_NoMovingJoint_ReturnsTheRoot()
        {
            var model = UrdfFiles.Read(UrdfFiles.Links("base", "plate") + UrdfFiles.Joint("bolts", "base", "plate", "fixed"));

            Assert.That(model.FlangeLink.Name, Is.EqualTo("base"));
        }

        [Test]
        public void CompleteMimics_ChainInReverseOrder_CompletesAll()
        {
            var model = UrdfFiles.Robot("odd_axes");
            var positions = new double[model.MovingJoints.Count];
            var given = new bool[positions.Length];
            Set(model, positions, given, "leader", 0.5);

            model.CompleteMimics(positions, given);

            Assert.That(positions[model.IndexOfMovingJoint("middle")], Is.EqualTo(0.2 * 0.5).Within(1e-15));
            Assert.That(positions[model.IndexOfMovingJoint("follower")], Is.EqualTo(-1.5 * 0.1 + 0.25).Within(1e-15));
        }

        [Test]
        public void CompleteMimics_MimicPositionGiven_KeepsItAndCompletesTheJointsThatFollowIt()
        {
            var model = UrdfFiles.Robot("odd_axes");
            var positions = new double[model.MovingJoints.Count];
            var given = new bool[positions.Length];
            Set(model, positions, given, "leader", 0.5);
            Set(model, positions, given, "middle", 0.3);

            model.CompleteMimics(positions, given);

            Assert.That(positions[model.IndexOfMovingJoint("middle")], Is.EqualTo(0.3));
            Assert.That(positions[model.IndexOfMovingJoint("follower")], Is.EqualTo(-1.5 * 0.3 + 0.25).Within(1e-15));
        }

        static void Set(RobotModel model, double[] positions, bool[] given, string joint, double value)
        {
            positions[model.IndexOfMovingJoint(joint)] = value;
            given[model.IndexOfMovingJoint(joint)] = true;
        }
    }
}
