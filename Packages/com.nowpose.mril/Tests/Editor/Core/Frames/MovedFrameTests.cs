using NUnit.Framework;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Tests.Core.Session;
using static Nowpose.Tests.Core.Frames.TreePoses;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>Tests what can move a frame: the joints of a robot, or a moving base.</summary>
    public class MovedFrameTests
    {
        [TestCase("arm/base", true)]
        [TestCase("arm/upper", false)]
        [TestCase("arm/finger", false)]
        public void IsFixed_OnALink_IsTrueIfNoJointMovesTheLinkAndTheRobotIsFixed(string link, bool isFixed)
        {
            var tree = NewTree();
            tree.Add(new MovingLinks("arm", TestRobot.Model));
            tree.Add(Pose(0, link, "plate"), isStationary: true);
            tree.Add(Pose(0, "plate", "screw"), isStationary: true);
            (bool, bool) AreFixed() => (FrameOf(tree, "plate").IsFixed, FrameOf(tree, "screw").IsFixed);
            tree.Evaluate(At(0));
            Assert.That(AreFixed(), Is.EqualTo((isFixed, isFixed)), "the robot is at the world's origin");

            tree.Add(Pose(0, "world", "arm/base", 1), isStationary: true);
            tree.Evaluate(At(0.1));
            Assert.That(AreFixed(), Is.EqualTo((isFixed, isFixed)), "the robot stands on a stationary frame");

            for (var k = 0; k <= 5; k++) tree.Add(Pose(k * Sampling, "world", "arm/base", k), isStationary: false);
            tree.Evaluate(At(5 * Sampling));
            tree.Evaluate(At(5 * Sampling));
            Assert.That(AreFixed(), Is.EqualTo((false, false)), "the robot moves");
        }

        [Test]
        public void IsFixed_ParentBecomesUnknown_IsFalse()
        {
            var tree = NewTree();
            tree.Add(Pose(0, "world", "table", 1), isStationary: true);
            tree.Add(Pose(0, "table", "plate", 1), isStationary: true);
            tree.Evaluate(At(0));
            Assert.That((FrameOf(tree, "table").IsFixed, FrameOf(tree, "plate").IsFixed), Is.EqualTo((true, true)));

            tree.Add(Pose(1, "hall", "table", 1), isStationary: true);
            tree.Evaluate(At(1));

            Assert.That((FrameOf(tree, "table").State, FrameOf(tree, "plate").State), Is.EqualTo((FrameState.Orphan, FrameState.Orphan)));
            Assert.That((FrameOf(tree, "table").IsFixed, FrameOf(tree, "plate").IsFixed), Is.EqualTo((false, false)));
        }

        static readonly RobotModel Robot = UrdfReader.Read(@"<robot name='r'>
                <link name='world'/><link name='table'/><link name='arm'/><link name='tool'/>
                <joint name='stand' type='fixed'><parent link='world'/><child link='table'/></joint>
                <joint name='turn' type='continuous'><parent link='table'/><child link='arm'/><axis xyz='0 0 1'/></joint>
                <joint name='flange' type='fixed'><parent link='arm'/><child link='tool'/></joint>
            </robot>", "test");

        [TestCase("world", 0, false)]
        [TestCase("table", 0, false)]
        [TestCase("table", 1, false)]
        [TestCase("arm", 0, true)]
        [TestCase("tool", 0, true)]
        [TestCase("tool", 1, true)]
        [TestCase("tool", 2, true)]
        [TestCase("elsewhere", 0, false)]
        public void IsCarried_RobotWhoseRootLinkIsTheWorld_IsTrueOnlyOnLinksThatMove(string parent, int trays, bool isCarried)
        {
            var tree = NewTree();
            tree.Add(new MovingLinks("", Robot));
            var below = new[] { "box", "tray", "pallet" };
            for (var i = trays; i >= 0; i--) tree.Add(Pose(0, i < trays ? below[i + 1] : parent, below[i]), isStationary: i > 1);
            tree.Evaluate(At(0));

            Assert.That(tree.IsCarried(tree.IndexOf("box")), Is.EqualTo(isCarried));
        }

        [Test]
        public void IsCarried_RobotStandsOnTheToolOfAnother_IsTrueOnItsTable()
        {
            var tree = NewTree();
            tree.Add(new MovingLinks("", Robot));
            tree.Add(new MovingLinks("small", Robot));
            tree.Add(Pose(0, "tool", "small/world"), isStationary: true);
            tree.Add(Pose(0, "small/table", "box"), isStationary: false);
            tree.Evaluate(At(0));

            Assert.That(tree.IsCarried(tree.IndexOf("box")));
        }
    }
}
