using System;
using System.Linq;
using NUnit.Framework;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Tests.Core.Session;
using static Nowpose.Tests.Core.Frames.TreePoses;

namespace Nowpose.Tests.Core.Frames
{
    public class HandOverTests
    {
        [Test]
        public void Reset_PoseRefusedBefore_DoesNotCountAfterwards()
        {
            var handOver = new HandOver();
            handOver.Refuse(Pose(0, "stop", "part"));

            handOver.Reset();

            Assert.That(handOver.IsOvertaken(Pose(1, "stop", "part"), "world", At(10)), Is.True);
        }

        [Test]
        public void Add_PoseFromTheOtherTopic_DiscardsTheWaitingPoses([Values] bool isStationary)
        {
            var handOver = new HandOver();
            handOver.Add(Pose(0, "tool", "part"), !isStationary);

            handOver.Add(Pose(1, "tool", "part"), isStationary);

            Assert.That((handOver.Count, handOver.IsStationary, handOver[0].Stamp), Is.EqualTo((1, isStationary, At(1))));
        }

        [Test]
        public void HandOver_FromAConveyorToAGripper_IsContinuousAndThenExact()
        {
            const double frameSeconds = 1 / 60.0, speed = 0.3, taken = 1.0;
            var arm = new MovingLinks("", TestRobot.Model);
            var tool = TestRobot.Model.IndexOfLink("tool_centre_point");
            var tree = NewTree();
            tree.Add(arm);
            RigidTransform? last = null;
            var sample = 0;
            for (var frame = 0; frame * frameSeconds < 2; frame++)
            {
                var now = frame * frameSeconds;
                // The gripper moves with the conveyor, 5 mm beside the part.
                var link = arm.Move(tool, UnitQuaternion.Identity.At(speed * now, 0, 0.1));
                for (; sample * Sampling <= now - 0.1; sample++)
                {
                    var t = sample * Sampling;
                    tree.Add(t < taken ? Pose(t, "world", "part", speed * t) : Pose(t, "tool_centre_point", "part", 0.005, 0, -0.1), isStationary: false);
                }
                tree.Evaluate(At(now));
                if (sample < 3) continue;
                var world = FrameOf(tree, "part").World;
                if (last is RigidTransform before)
                    Assert.That(Distance(before, world), Is.EqualTo(speed * frameSeconds).Within(1e-3), "moved at " + now + " s");
                last = world;
                if (now > taken + 0.1 + 2 * Sampling + PoseFade.Seconds)
                    Assert.That(Distance(world, link * UnitQuaternion.Identity.At(0.005, 0, -0.1)), Is.LessThan(1e-9), "at " + now + " s");
            }
        }

        [Test]
        public void HandOver_FastObjectStopsAndItsPoseArrivesLate_MovesToItsPlaceWithoutAJump()
        {
            const double frameSeconds = 1 / 60.0, speed = 2, stopped = 1.0, late = 0.2;
            var tree = NewTree();
            tree.Add(Pose(0, "world", "stop", speed * stopped), isStationary: true);
            var (sample, greatest, last) = (0, 0.0, (RigidTransform?)null);
            for (var frame = 0; frame * frameSeconds < 2; frame++)
            {
                var now = frame * frameSeconds;
                for (; sample * Sampling <= now - late; sample++)
                {
                    var t = sample * Sampling;
                    tree.Add(t < stopped ? Pose(t, "world", "part", speed * t) : Pose(t, "stop", "part"), isStationary: false);
                }
                tree.Evaluate(At(now));
                if (sample < 6) continue;
                var world = FrameOf(tree, "part").World;
                if (last is RigidTransform before) greatest = System.Math.Max(greatest, Distance(before, world));
                last = world;
            }

            Assert.That(last.Value.X, Is.EqualTo(speed * stopped).Within(1e-9));
            Assert.That(greatest, Is.LessThan(0.1), "m in a frame; the jump would be 0.4 m");
        }

        [Test]
        public void HandOver_ObjectThatWasHeld_IsAtItsPlaceAtOnce()
        {
            var tree = NewTree();
            tree.Add(Pose(0, "world", "fixture", 1), isStationary: true);
            for (var i = 0; i < 10; i++) tree.Add(Pose(i * Sampling, "world", "part", 0.85), isStationary: false);
            tree.Evaluate(At(2));
            Assert.That(FrameOf(tree, "part").State, Is.EqualTo(FrameState.Held));

            tree.Add(Pose(2, "fixture", "part"), isStationary: false);
            tree.Evaluate(At(2.1));

            Assert.That(FrameOf(tree, "part").State, Is.EqualTo(FrameState.Current));
            Assert.That(FrameOf(tree, "part").World.X, Is.EqualTo(1));
        }

        [Test]
        public void HandOver_OnePoseInTheNewParent_IsAssumedAtRestUpToTheHorizonCap()
        {
            var tree = NewTree();
            tree.Add(Pose(0, "world", "fixture", 1), isStationary: true);
            tree.Add(Pose(0, "world", "part"), isStationary: false);
            tree.Evaluate(At(0.1));
            Assert.That(FrameOf(tree, "part").State, Is.EqualTo(FrameState.Held), "a single pose does not determine a speed");

            tree.Add(Pose(0.2, "fixture", "part", 0.5), isStationary: false);
            tree.Evaluate(At(0.3));

            Assert.That(FrameOf(tree, "part").State, Is.EqualTo(FrameState.Current));
            tree.Evaluate(At(0.45));
            Assert.That(FrameOf(tree, "part").World.X, Is.EqualTo(1.5).Within(1e-9));
            tree.Evaluate(At(0.55));
            Assert.That(FrameOf(tree, "part").State, Is.EqualTo(FrameState.Held), "0.35 s exceeds the horizon cap");
        }

        [Test]
        public void Add_PoseInThePreviousParentAfterTheHandOver_IsLate()
        {
            var tree = NewTree();
            tree.Add(Pose(1, "world", "a"), isStationary: false);
            tree.Add(Pose(1.1, "b", "a"), isStationary: false);
            tree.Evaluate(At(1.1));

            Assert.That(tree.Add(Pose(1.05, "world", "a"), isStationary: false), Is.EqualTo(DropReason.LateSample));
            tree.Evaluate(At(1.12));
            Assert.That(FrameOf(tree, "a").Parent, Is.EqualTo("b"));
        }

        [Test]
        public void Add_PoseInThePreviousParentWhileTheNewParentIsPending_IsLate()
        {
            var tree = NewTree();
            tree.Add(Pose(1, "world", "a"), isStationary: false);
            tree.Add(Pose(1.1, "b", "a"), isStationary: false);

            Assert.That(tree.Add(Pose(1.05, "world", "a"), isStationary: false), Is.EqualTo(DropReason.LateSample));
            tree.Evaluate(At(1.12));
            Assert.That(FrameOf(tree, "a").Parent, Is.EqualTo("b"));
        }

        [Test]
        public void IsOvertaken_RefusedPosesProveThatTheClockWentBack_IsFalse()
        {
            var handOver = new HandOver();
            bool IsOvertaken(double seconds) => handOver.IsOvertaken(Pose(seconds, "b", "a"), "world", At(100));

            Assert.That(IsOvertaken(1) && IsOvertaken(1.1) && IsOvertaken(1.2), Is.True, "no pose was refused");
            handOver.Refuse(Pose(1, "b", "a"));
            Assert.That(IsOvertaken(1), Is.True, "not newer than the refused pose");
            Assert.That(IsOvertaken(1.1) || IsOvertaken(1.1), Is.False);
            handOver.EndRefusals();
            Assert.That(IsOvertaken(1.1), Is.True);
        }

        // The sources of both parents have the same clock. Two late poses can be overtaken if they are not very late.
        [TestCase(0.1, false, "world")]
        [TestCase(0.1, true, "b")]
        [TestCase(10, false, "b")]
        [TestCase(10, true, "c")]
        public void Add_ClockOfTheSourceSetBackWithAnotherParent_HandsOverAfterTwoPoses(double step, bool isPending, string expected)
        {
            var tree = NewTree();
            tree.Add(Pose(19.9, "world", "a"), isStationary: false);
            tree.Evaluate(At(19.9));
            if (isPending) tree.Add(Pose(20, "b", "a"), isStationary: false);
            var parent = isPending ? "c" : "b";

            Assert.That(tree.Add(Pose(19.9 - step, parent, "a", 1), isStationary: false), Is.EqualTo(DropReason.LateSample));
            tree.Add(Pose(19.9 - step, parent, "a", 1), isStationary: false);
            tree.Add(Pose(19.9 - step + Sampling, parent, "a", 2), isStationary: false);
            tree.Evaluate(At(19.9 - step + Sampling));

            Assert.That(FrameOf(tree, "a").Parent, Is.EqualTo(expected));
            if (step > 1) Assert.That(FrameOf(tree, "a").Newest, Is.EqualTo((ControlTime?)At(19.9 - step + Sampling)));
        }

        [Test]
        public void Add_LatePosesInTwoParentsInTurn_AreNoHandOver()
        {
            var tree = NewTree();
            for (var k = 0; k < 20; k++)
            {
                tree.Add(Pose(20 + k * Sampling, "world", "a"), isStationary: false);
                tree.Add(Pose(10 + k * Sampling, "b", "a"), isStationary: false);
                tree.Evaluate(At(20 + k * Sampling));
            }

            Assert.That(FrameOf(tree, "a").Parent, Is.EqualTo("world"));
        }

        [Test]
        public void Reset_StationaryPosePending_IsUsedAfterTheReset()
        {
            var tree = NewTree();
            tree.Add(Pose(1, "world", "a", 1), isStationary: false);
            tree.Evaluate(At(1));
            tree.Add(Pose(0, "world", "a", 2), isStationary: true);

            tree.Reset();
            tree.Evaluate(At(1));

            Assert.That(FrameOf(tree, "a").IsStationary, Is.True);
            Assert.That(FrameOf(tree, "a").State, Is.EqualTo(FrameState.Current));
        }

        [TestCase(0, false)]
        [TestCase(0.01, true)]
        public void Add_DisplayedObject_IsContinuousIfBlended(double blend, bool isContinuous)
        {
            var tree = new FrameTree(() => new BodyPredictor("linear", new PredictionLimits(), blend));
            for (var k = 0; k <= 10; k++) tree.Add(Pose(k * Sampling, "world", "box", k * k * Sampling * Sampling), isStationary: false);
            var now = At(11 * Sampling + 0.05);
            tree.Evaluate(now);
            var before = FrameOf(tree, "box").World.X;

            tree.Add(Pose(11 * Sampling, "world", "box", 11 * 11 * Sampling * Sampling), isStationary: false);
            tree.Evaluate(now);

            Assert.That(Math.Abs(FrameOf(tree, "box").World.X - before), isContinuous ? Is.LessThan(1e-9) : Is.GreaterThan(1e-3));
        }
    }
}
