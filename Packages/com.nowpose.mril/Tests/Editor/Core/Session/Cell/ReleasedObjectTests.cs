using System;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Messages;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests the state of an object that a gripper has released. Its own source reports whether it is moved again.</summary>
    public class ReleasedObjectTests
    {
        [TestCase(true, PoseState.Current)]
        [TestCase(false, PoseState.Held)]
        public void StateOf_ReleasedTrackedObject_IsCurrentOnlyWhileItsSourceSendsPoses(bool isSent, PoseState expected)
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                if (isSent || t < Open + 0.5) cell.Send("world", "box", t, At(1, 0));
            };
            Move(cell);
            var released = Find(cell, "box").World;
            Assert.That((grip.Held, cell.Session.Frames.StateOf(Find(cell, "box"))), Is.EqualTo(((string)null, PoseState.Current)));

            Until(cell, Open + 2);

            Assert.That(cell.Session.Frames.StateOf(Find(cell, "box")), Is.EqualTo(expected));
            Assert.That(Distance(Find(cell, "box").World, released), Is.Zero, "it stays at the place of the release");
        }

        [Test]
        public void StateOf_ReleasedStationaryObject_IsCurrent()
        {
            var (cell, _) = NewCell("box");
            cell.Send("world", "box", 20, At(1, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);
            Move(cell);

            Until(cell, Open + 2);

            Assert.That(cell.Session.Frames.StateOf(Find(cell, "box")), Is.EqualTo(PoseState.Current));
        }

        // Also if the object was tracked before.
        [Test]
        public void Faults_StationaryPoseOfAReleasedObjectIsNotSentAgain_NamesTheConnection([Values] bool wasTracked)
        {
            var (cell, _) = NewCell("box");
            if (wasTracked) cell.Send("world", "box", 19, At(1, 0));
            cell.Run(0.1);
            cell.Send("world", "box", 20, At(1, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);
            Move(cell);

            cell.Reconnect();
            Until(cell, Open + 6);

            var fault = cell.Session.Frames.Faults(null).Single();
            Assert.That((fault.Name, fault.State, fault.Reason), Is.EqualTo(("box", PoseState.Held, FrameMessages.OlderThanConnection)));
        }

        [Test]
        public void StateOf_ReleasedStationaryObjectIsPublished_FollowsItsSourceOnlyToAnotherPose()
        {
            var (cell, _) = NewCell("box");
            cell.Send("world", "box", 0, At(1, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);
            Move(cell);
            var released = Find(cell, "box").World;

            Publish(cell, 1);
            Until(cell, Open + 1);
            Assert.That(Distance(Find(cell, "box").World, released), Is.Zero, "its source repeats the pose from before the grip");

            Publish(cell, 0.5);
            Until(cell, Open + 2);
            Assert.That(Distance(Find(cell, "box").World, At(0.5, 0)), Is.LessThan(1e-9));
        }

        // The gripper puts the box back on a shuttle. The source of the box repeats its pose on the shuttle.
        [TestCase(0)]
        [TestCase(0.001)]
        public void StateOf_CarrierMovesAfterTheRelease_IsHeldUntilTheSourceReportsAnotherPose(double noise)
        {
            const double start = Open + 1.5;
            var random = new Random(1);
            var (cell, _) = NewCell("box");
            var y = 0.02;
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                var x = 1 + 0.2 * Math.Max(0, t - start);
                cell.Send("world", "shuttle", t, At(x + noise * random.NextNormal(), noise * random.NextNormal()));
                cell.Send("shuttle", "box", t, At(0.05, y));
            };
            Move(cell);
            Until(cell, start, t => Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current), $"{t} s"));
            var released = Find(cell, "box").World;
            Assert.That(Find(cell, "box").GripFault, Is.Null);

            Until(cell, start + 0.5);
            var since = cell.Session.Frames.HeldSince(Find(cell, "box"));
            Until(cell, start + 2, t => Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held), $"{t} s"));
            Assert.That(Distance(Find(cell, "box").World, released), Is.Zero);
            Assert.That(Find(cell, "box").GripFault, Is.EqualTo(FrameMessages.CarrierMoved));
            Assert.That(since?.SinceEpoch.TotalSeconds, Is.InRange(start, start + 0.4));
            Assert.That(cell.Session.Frames.HeldSince(Find(cell, "box")), Is.EqualTo(since));

            y = 0.03;
            Until(cell, start + 3);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
            Assert.That(Distance(Find(cell, "box").World, Find(cell, "shuttle").World * At(0.05, y)), Is.LessThan(1e-9));
        }

        // The shuttle leaves while the gripper holds the box, and waits elsewhere.
        [Test]
        public void StateOf_CarrierMovesOnlyDuringTheGrip_IsCurrent()
        {
            var (cell, _) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "shuttle", t, At(1, 0.2 * Math.Min(1, Math.Max(0, t - Close - 0.2))));
                cell.Send("shuttle", "box", t, At(0.05, 0.02));
            };
            Move(cell);

            Until(cell, Open + 2, t => Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current), $"{t} s"));
        }

        // At first, the predicted poses say that the box is within reach of a gripper that then holds another object.
        [Test]
        public void StateOf_GripIsWithdrawnAfterTheCarrierMoved_IsStillHeld([Values] bool hasClockStepped)
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "shuttle", t, At(1 + 0.2 * Math.Max(0, Math.Min(t, Open + 2.5) - Open - 1.5), 0));
                cell.Send("shuttle", "box", t, At(0.05, 0.02));
            };
            Move(cell);
            Until(cell, Open + 3);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));
            if (hasClockStepped) StepClock(cell);
            var (tree, box) = (cell.Session.Frames.Tree, cell.Session.Frames.Tree.IndexOf("box"));
            var released = tree[box].Reach;

            tree.Put(box, new ReachPlace(grip, "tool_centre_point", At(0, 0), ControlTime.FromSeconds(cell.Now + cell.ClockStep), isReleased: false));
            tree.Put(box, released);
            cell.Run(1);

            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));
        }

        // The message about the release of another gripper arrives after this gripper has taken the object.
        [Test]
        public void Put_GripIsWithdrawnToALaterKnownRelease_FollowsTheSourceOnceItMoves()
        {
            var (cell, grip) = NewCell("box");
            var start = cell.Now;
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(t < start + 4 ? 1 : 2, 0));
            };
            Until(cell, start + 2);
            var (tree, box) = (cell.Session.Frames.Tree, cell.Session.Frames.Tree.IndexOf("box"));

            tree.Put(box, new ReachPlace(grip, "tool_centre_point", At(0, 0), ControlTime.FromSeconds(start + 1.9), isReleased: false));
            tree.Put(box, new ReachPlace(grip, "world", At(1.5, 0), ControlTime.FromSeconds(start + 1.8), isReleased: true));
            Until(cell, start + 3.5);
            Assert.That(Distance(tree[box].World, At(1.5, 0)), Is.LessThan(1e-6));

            Until(cell, start + 6);

            Assert.That(Distance(tree[box].World, At(2, 0)), Is.LessThan(1e-6));
        }

        [Test]
        public void StateOf_GripAndReleaseInOneFrameAndTheCarrierMoves_IsHeld()
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "shuttle", t, At(1 + 0.2 * Math.Max(0, t - Open), 0));
                cell.Send("shuttle", "box", t, At(0.05, 0.02));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            var (tree, box) = (cell.Session.Frames.Tree, cell.Session.Frames.Tree.IndexOf("box"));

            tree.Put(box, new ReachPlace(grip, "tool_centre_point", At(0, 0), ControlTime.FromSeconds(Close - 0.2), isReleased: false));
            tree.Put(box, new ReachPlace(grip, "world", At(1.05, 0.02), ControlTime.FromSeconds(Close - 0.1), isReleased: true));
            Until(cell, Open - 0.5);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
            Until(cell, Open + 2);

            Assert.That(Find(cell, "box").GripFault, Is.EqualTo(FrameMessages.CarrierMoved));
        }

        static void StepClock(CellSession cell)
        {
            const double step = 7;
            var sampling = cell.Sampling;
            cell.Sampling = null;
            cell.ClockStep = step;
            cell.Run(4);
            cell.Sampling = t =>
            {
                cell.SendJoints(t + step, Shoulder(t), 0);
                cell.Send("world", "shuttle", t + step, At(1.2, 0));
                cell.Send("shuttle", "box", t + step, At(0.05, 0.02));
            };
            cell.Run(1);
            Assert.That((cell.Session.Clock.Steps, StateOf(cell)), Is.EqualTo((1, PoseState.Held)));
        }

        static PoseState StateOf(CellSession cell) => cell.Session.Frames.StateOf(Find(cell, "box"));

        static void Publish(CellSession cell, double x) => cell.Session.Listener.FramesReceived(
            new TransformsMessage(At(x, 0).ToTransform(default, "world", "box")), true, HeadsetTime.FromSeconds(cell.Now));

        static void Move(CellSession cell)
        {
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Open - 0.2);
            cell.Send("grip", Open, 0);
            Until(cell, Open + 0.5);
        }
    }
}
