using System;
using System.Linq;
using NUnit.Framework;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Tests.Core.Session;
using static Nowpose.Tests.Core.Frames.TreePoses;

namespace Nowpose.Tests.Core.Frames
{
    public class FrameTreeTests
    {
        /// <summary>Returns the 4×4 matrix of a pose by the textbook formula, independently of the package's code.</summary>
        static double[,] MatrixOf(in FrameTransform p)
        {
            double x = p.Qx, y = p.Qy, z = p.Qz, w = p.Qw;
            return new[,]
            {
                { w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), p.X },
                { 2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x), p.Y },
                { 2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z, p.Z },
                { 0, 0, 0, 1 },
            };
        }

        static double[,] Product(double[,] a, double[,] b)
        {
            var product = new double[4, 4];
            for (var i = 0; i < 4; i++)
                for (var j = 0; j < 4; j++)
                    for (var k = 0; k < 4; k++) product[i, j] += a[i, k] * b[k, j];
            return product;
        }

        static UnitQuaternion Turned(double x, double y, double z) => UnitQuaternion.Exp(new Vector3D(x, y, z));

        [Test]
        public void World_ChainOfFrames_IsTheProductOfTheirMatrices()
        {
            const int seed = 5;
            var random = new Random(seed);
            double Next() => 4 * random.NextDouble() - 2;
            var tree = NewTree();
            var poses = Enumerable.Range(0, ProtocolLimits.FrameDepth)
                .Select(i => Pose(0, i == 0 ? "world" : "f" + (i - 1), "f" + i, Next(), Next(), Next(), Turned(Next(), Next(), Next()))).ToArray();
            // Children are added before their parents.
            foreach (var pose in poses.Reverse()) Assert.That(tree.Add(pose, isStationary: true), Is.EqualTo(DropReason.None));

            tree.Evaluate(At(0));

            var expected = MatrixOf(poses[0]);
            for (var i = 0; i < poses.Length; i++)
            {
                if (i > 0) expected = Product(expected, MatrixOf(poses[i]));
                var frame = FrameOf(tree, "f" + i);
                Assert.That(frame.State, Is.EqualTo(FrameState.Current));
                Assert.That(frame.World.ToRowMajor16(), Is.EqualTo(expected.Cast<double>()).Within(1e-12), "frame " + i + ", seed " + seed);
            }
        }

        [Test]
        public void World_FrameOnALink_MovesExactlyWithIt()
        {
            var arm = new MovingLinks("", TestRobot.Model);
            var tree = NewTree();
            tree.Add(arm);
            tree.Add(Pose(0, "tool_centre_point", "part", 0, 0.1, 0, Turned(0, 0, 0.5)), isStationary: true);
            for (var i = 0; i < 5; i++)
            {
                var link = arm.Move(TestRobot.Model.IndexOfLink("tool_centre_point"), Turned(0, 0.1 * i, 0.3 * i).At(i, 0.2, 0));

                tree.Evaluate(At(0.016 * i));

                var expected = link * Turned(0, 0, 0.5).At(0, 0.1, 0);
                Assert.That(FrameOf(tree, "part").World.ToRowMajor16(), Is.EqualTo(expected.ToRowMajor16()).Within(1e-12));
            }
        }

        [Test]
        public void World_FrameNamedLikeARobotsRootLink_MovesTheRobotAndItsObject()
        {
            var arm = new MovingLinks("arm1", TestRobot.Model);
            var tree = NewTree();
            tree.Add(arm);
            arm.Move(TestRobot.Model.IndexOfLink("lower"), UnitQuaternion.Identity.At(0, 0, 1));
            tree.Add(Pose(0, "arm1/lower", "part"), isStationary: true);
            tree.Add(Pose(0, "world", "arm1/base", 5, 0, 0), isStationary: true);

            tree.Evaluate(At(0));

            Assert.That(tree.RootOf(arm).World.X, Is.EqualTo(5));
            Assert.That((FrameOf(tree, "part").World.X, FrameOf(tree, "part").World.Z), Is.EqualTo((5.0, 1.0)));
        }

        [Test]
        public void World_TwoRobotsWithEqualLinkNames_AreSeparate()
        {
            MovingLinks left = new MovingLinks("left", TestRobot.Model), right = new MovingLinks("right", TestRobot.Model);
            var tree = NewTree();
            tree.Add(left);
            tree.Add(right);
            var tool = TestRobot.Model.IndexOfLink("tool_centre_point");
            left.Move(tool, UnitQuaternion.Identity.At(-1, 0, 0));
            right.Move(tool, UnitQuaternion.Identity.At(1, 0, 0));
            tree.Add(Pose(0, "left/tool_centre_point", "a"), isStationary: true);
            tree.Add(Pose(0, "right/tool_centre_point", "b"), isStationary: true);
            tree.Add(Pose(0, "tool_centre_point", "c"), isStationary: true);

            tree.Evaluate(At(0));

            Assert.That((FrameOf(tree, "a").World.X, FrameOf(tree, "b").World.X), Is.EqualTo((-1.0, 1.0)));
            Assert.That(FrameOf(tree, "c").State, Is.EqualTo(FrameState.Orphan), "no robot without a namespace exists");
        }

        [Test]
        public void World_ConstantVelocity_IsThePoseAtTheDisplayTime()
        {
            var tree = NewTree();
            for (var k = 0; k <= 20; k++) tree.Add(Pose(k * Sampling, "world", "box", 0.5 * k * Sampling), isStationary: false);

            tree.Evaluate(At(20 * Sampling + 0.1));

            Assert.That(FrameOf(tree, "box").World.X, Is.EqualTo(0.5 * (20 * Sampling + 0.1)).Within(1e-9));
            Assert.That(FrameOf(tree, "box").Newest, Is.EqualTo(At(20 * Sampling)));
        }

        [Test]
        public void State_EachKindOfSampleAndParent_IsReported()
        {
            var arm = new MovingLinks("", TestRobot.Model);
            var tree = NewTree();
            tree.Add(arm);
            tree.Add(Pose(0, "lower", "part"), isStationary: true);
            tree.Add(Pose(0, "nowhere", "orphan"), isStationary: true);
            tree.Add(Pose(0, "orphan", "child"), isStationary: true);
            for (var k = 0; k <= 5; k++) tree.Add(Pose(k * Sampling, "world", "box"), isStationary: false);
            tree.Add(Pose(0, "box", "lid"), isStationary: true);

            tree.Evaluate(At(5 * Sampling + 0.1));

            Assert.That(tree.IndexOf("missing"), Is.EqualTo(-1));
            Assert.That(new[] { "part", "orphan", "child", "box", "lid" }.Select(name => FrameOf(tree, name).State), Is.EqualTo(new[]
            {
                FrameState.Current, FrameState.Orphan, FrameState.Orphan, FrameState.Current, FrameState.Current,
            }));
            arm.IsCurrent = false;
            tree.Evaluate(At(5 * Sampling + 1));
            Assert.That(new[] { "part", "box", "lid" }.Select(name => FrameOf(tree, name).State), Is.EqualTo(new[]
            {
                FrameState.ParentNotCurrent, FrameState.Held, FrameState.ParentNotCurrent,
            }));
        }

        [Test]
        public void State_RootOfARobotIsAnOrphan_ObjectsOnTheRobotAreOrphansUntilItsParentIsKnown()
        {
            var arm = new MovingLinks("arm", TestRobot.Model);
            var tree = NewTree();
            tree.Add(arm);
            tree.Add(Pose(0, "hall", "arm/base", 1), isStationary: true);
            tree.Add(Pose(0, "arm/tool_centre_point", "part", 0.1), isStationary: true);
            tree.Add(Pose(0, "part", "screw", 0.01), isStationary: true);

            tree.Evaluate(At(0));
            Assert.That(new[] { "part", "screw" }.Select(name => FrameOf(tree, name).State), Is.All.EqualTo(FrameState.Orphan));

            tree.Add(Pose(0, "world", "hall", 10), isStationary: true);
            tree.Evaluate(At(0.1));
            Assert.That(FrameOf(tree, "screw").State, Is.EqualTo(FrameState.Current));
            Assert.That(FrameOf(tree, "screw").World.X, Is.EqualTo(11.11).Within(1e-12));
        }

        /// <summary>
        /// A digital twin reports the object in the gripper as the parent of the robot. The reported parents have no cycle, but the
        /// displayed parents do.
        /// </summary>
        [Test]
        public void Evaluate_GripByReachClosesACycle_ReportsAnOrphanAndTerminates()
        {
            var arm = new MovingLinks("", TestRobot.Model);
            var tree = NewTree();
            tree.Add(arm);
            tree.Add(Pose(0, "world", "part"), isStationary: true);
            tree.Evaluate(At(1));
            tree.Put(0, new ReachPlace(null, "tool_centre_point", RigidTransform.Identity, At(1), isReleased: false));
            tree.Add(Pose(0, "part", TestRobot.Model.Root.Name), isStationary: true);

            tree.Evaluate(At(1.1));

            Assert.That(Enumerable.Range(0, tree.Count).Select(i => tree[i].State), Does.Contain(FrameState.Orphan));
            Assert.That(double.IsFinite(tree.HeldOf(0).X + tree.HeldOf(1).X), Is.True);
            tree.PoseAt(0, tree[0].Reach, At(1.1), out var origin);
            Assert.That(origin, Is.EqualTo(PoseOrigin.None));
            Assert.That(() => tree.IsBelow(0, 0), Throws.Nothing);
        }

        [Test]
        public void Add_Cycle_IsRefusedAndThePreviousParentStays()
        {
            var tree = NewTree();
            tree.Add(Pose(0, "world", "a", 1), isStationary: true);
            tree.Add(Pose(0, "a", "b", 1), isStationary: true);

            Assert.That(tree.Add(Pose(1, "b", "a", 1), isStationary: true), Is.EqualTo(DropReason.FrameCycle));
            tree.Evaluate(At(1));
            Assert.That(FrameOf(tree, "b").World.X, Is.EqualTo(2));
        }

        [Test]
        public void Reset_TrackedFrame_KeepsItsPlaceAndIsMissingUntilTheNextSample()
        {
            var tree = NewTree();
            tree.Add(Pose(0, "world", "box", 3), isStationary: false);
            tree.Add(Pose(0, "world", "table", 4), isStationary: true);
            tree.Evaluate(At(0));

            tree.Reset();
            tree.Evaluate(At(-500));

            Assert.That((FrameOf(tree, "box").World.X, FrameOf(tree, "box").State), Is.EqualTo((3.0, FrameState.Missing)));
            Assert.That((FrameOf(tree, "table").World.X, FrameOf(tree, "table").State), Is.EqualTo((4.0, FrameState.Current)));
        }

        [Test]
        public void HeldOf_ChainOnAHeldLink_IsTheProductOfTheNewestPoses()
        {
            var tree = NewTree();
            var robot = new MovingLinks("arm", TestRobot.Model);
            tree.Add(robot);
            var link = TestRobot.Model.IndexOfLink("tool_centre_point");
            robot.Move(link, RigidTransform.FromXyzRpy(5, 5, 5, 0, 0, 0));
            var held = robot.Hold(link, RigidTransform.FromXyzRpy(1, 2, 3, 0.1, 0.2, 0.3));
            for (var i = 0; i < 5; i++)
            {
                tree.Add(Pose(i * Sampling, "world", "arm/base", x: i), isStationary: false);
                tree.Add(Pose(i * Sampling, "arm/tool_centre_point", "plate", y: i), isStationary: false);
            }
            tree.Add(Pose(0, "plate", "screw", z: 0.5), isStationary: true);
            tree.Add(Pose(0, "nowhere", "orphan", z: 0.5), isStationary: true);

            tree.Evaluate(At(0.2));

            var expected = RigidTransform.FromXyzRpy(4, 0, 0, 0, 0, 0) * held * RigidTransform.FromXyzRpy(0, 4, 0.5, 0, 0, 0);
            Assert.That(Distance(tree.HeldOf(tree.IndexOf("screw")), expected), Is.LessThan(1e-12));
            Assert.That(tree.HeldOf(tree.IndexOf("orphan")), Is.EqualTo(RigidTransform.Identity), "the displayed pose");
        }
    }
}
