using System;
using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Protocol.Cell
{
    public class FrameParentsTests
    {
        FrameParents _frames;

        [SetUp]
        public void Create() => _frames = new FrameParents();

        void Set(string child, string parent) => Assert.That(_frames.TrySet(child, parent), Is.EqualTo(DropReason.None));

        [Test]
        public void TrySet_ChangedParent_ReplacesThePreviousParent()
        {
            Set("box", "belt");
            Set("box", "arm1/tool0");

            Assert.That(_frames["box"], Is.EqualTo("arm1/tool0"));
        }

        [Test]
        public void TrySet_Cycle_IsRefusedAndThePreviousParentStays()
        {
            Set("a", "world");
            Set("b", "a");
            Set("c", "b");

            Assert.That(_frames.TrySet("a", "c"), Is.EqualTo(DropReason.FrameCycle));
            Assert.That(_frames["a"], Is.EqualTo("world"));
        }

        [Test]
        public void TrySet_LinksThatAreAlsoPublished_DoNotCountTowardsTheDepth()
        {
            _frames = new FrameParents(frame => frame == "base" || frame.StartsWith("link", StringComparison.Ordinal) ? "base" : null);
            Set("link0", "base");
            for (var i = 1; i <= ProtocolLimits.FrameDepth; i++) Set("link" + i, "link" + (i - 1));

            Set("part", "link" + ProtocolLimits.FrameDepth);

            Assert.That(_frames.TrySet("base", "part"), Is.EqualTo(DropReason.FrameCycle));
        }

        [Test]
        public void TrySet_CycleBeforeAnyFrameHasARoot_IsRefused()
        {
            Set("a", "b");
            Set("b", "c");

            Assert.That(_frames.TrySet("c", "a"), Is.EqualTo(DropReason.FrameCycle));
        }

        [Test]
        public void TrySet_ParentChangedSoThatNoCycleResults_IsAccepted()
        {
            Set("a", "b");
            Assert.That(_frames.TrySet("b", "a"), Is.EqualTo(DropReason.FrameCycle));
            Set("a", "world");

            Set("b", "a");
        }

        [TestCase("a", "a", DropReason.OwnParent)]
        [TestCase("world", "map", DropReason.WorldAsChild)]
        public void TrySet_InvalidPair_IsRefused(string child, string parent, object expected) =>
            Assert.That(_frames.TrySet(child, parent), Is.EqualTo((DropReason)expected));

        [Test]
        public void TrySet_Chain_IsAcceptedUpToDepth16()
        {
            for (var i = 1; i <= 16; i++) Set("f" + i, i == 1 ? "world" : "f" + (i - 1));

            Assert.That(_frames.TrySet("f17", "f16"), Is.EqualTo(DropReason.FrameTooDeep));
        }

        [Test]
        public void TrySet_FrameWithDescendants_CountsTheirDepth()
        {
            for (var i = 2; i <= 9; i++) Set("a" + i, "a" + (i - 1));
            for (var i = 1; i <= 8; i++) Set("b" + i, i == 1 ? "world" : "b" + (i - 1));

            Assert.That(_frames.TrySet("a1", "b8"), Is.EqualTo(DropReason.FrameTooDeep), "8 + 1 + 8 transforms");
            Set("a1", "b7");
        }

        [Test]
        public void TrySet_FrameCount_IsLimitedTo256()
        {
            for (var i = 0; i < 256; i++) Set("f" + i, "world");

            Assert.That(_frames.TrySet("f256", "world"), Is.EqualTo(DropReason.TooManyFrames));
            Set("f7", "f6");
            Assert.That(_frames.Remove("f3"), Is.True);
            Set("f256", "world");
        }

        [Test]
        public void HasChildren_ParentsChange_CountsThePresentChildren()
        {
            Set("a", "belt");
            Set("b", "belt");
            Set("a", "world");
            Assert.That(_frames.HasChildren("belt"), Is.True);

            Assert.That(_frames.Remove("b"), Is.True);

            Assert.That((_frames.HasChildren("belt"), _frames.HasChildren("world"), _frames.Remove("b")), Is.EqualTo((false, true, false)));
        }

        // A pallet with many parts is put on another conveyor. Each part must be compared with the frames above it, but not with all other parts.
        [Test]
        public void TrySet_ManyFramesChangeTheirParent_LooksOnlyAtTheFramesAbove()
        {
            const int Parts = 250;
            var steps = 0;
            _frames = new FrameParents(_ =>
            {
                steps++;
                return null;
            });
            for (var i = 1; i <= 5; i++) Set("belt" + i, i == 1 ? "world" : "belt" + (i - 1));
            for (var i = 0; i < Parts; i++) Set("part" + i, "world");
            steps = 0;

            for (var i = 0; i < Parts; i++) Set("part" + i, "belt5");

            Assert.That(steps, Is.LessThanOrEqualTo(Parts * ProtocolLimits.FrameDepth));
        }

        [Test]
        public void TrySet_CycleThroughARobot_IsRefused()
        {
            var frames = new FrameParents(link => link.StartsWith("arm/", StringComparison.Ordinal) ? "arm/base" : null);
            Assert.That(frames.TrySet("box", "arm/tool0"), Is.EqualTo(DropReason.None));

            Assert.That(frames.TrySet("arm/base", "box"), Is.EqualTo(DropReason.FrameCycle));
            Assert.That(frames.TrySet("arm/base", "world"), Is.EqualTo(DropReason.None));
        }

        [Test]
        public void TrySet_FramesOnARobot_LinksDoNotAddDepth()
        {
            var frames = new FrameParents(link => link.StartsWith("arm/", StringComparison.Ordinal) ? "arm/base" : null);
            Assert.That(frames.TrySet("arm/base", "world"), Is.EqualTo(DropReason.None));
            for (var i = 1; i <= 15; i++)
                Assert.That(frames.TrySet("f" + i, i == 1 ? "arm/tool0" : "f" + (i - 1)), Is.EqualTo(DropReason.None));

            Assert.That(frames.TrySet("f16", "f15"), Is.EqualTo(DropReason.FrameTooDeep));
        }

        [Test]
        public void TrySet_LinksFormACycle_IsRefusedWithoutAnEndlessLoop()
        {
            var links = new Dictionary<string, string>();
            var frames = new FrameParents(link => links.TryGetValue(link, out var root) ? root : null);
            Assert.That(frames.TrySet("box", "arm/tool0"), Is.EqualTo(DropReason.None));
            Assert.That(frames.TrySet("arm/base", "box"), Is.EqualTo(DropReason.None));
            links["arm/tool0"] = "arm/base";

            Assert.That(frames.TrySet("lid", "box"), Is.EqualTo(DropReason.FrameCycle));
        }

        [Test]
        public void TrySet_RandomChanges_NeverFormsACycleOrExceedsTheDepth()
        {
            const int Seed = 5;
            var random = new Random(Seed);
            for (var i = 0; i < 20_000; i++)
            {
                _frames.TrySet("f" + random.Next(30), random.Next(6) == 0 ? "world" : "f" + random.Next(30));
                if (random.Next(20) == 0) _frames.Remove("f" + random.Next(30));
                var depth = 0;
                for (var frame = "f" + random.Next(30); frame != null; frame = _frames[frame]) depth++;
                Assert.That(depth, Is.LessThanOrEqualTo(17), "16 transforms, seed " + Seed);
            }
        }
    }
}
