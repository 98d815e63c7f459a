using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>
    /// Tests the state of the objects of a gripper while it is unknown what the gripper holds. The sources of the objects repeat their poses.
    /// </summary>
    public class UnknownGripTests
    {
        [TestCase(Close + 1, "box")]
        [TestCase(Open + 1, null)]
        public void StateOf_SignalEndsDuringOrAfterTheGrip_IsHeldSinceTheEndUntilTheSignalContinues(double end, string held)
        {
            var (cell, grip) = NewGrip();
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            cell.Send("grip", Open, 0);
            Until(cell, end);
            Assert.That((grip.Held, StateOf(cell)), Is.EqualTo((held, PoseState.Current)));

            Report(cell, new JointReport("grip", JointDataState.Stale, ControlTime.FromSeconds(end), "its source has ended"));
            Until(cell, end + 0.1, _ =>
                Assert.That((StateOf(cell), cell.Session.Frames.HeldSince(Find(cell, "box"))), Is.EqualTo((PoseState.Held, (ControlTime?)ControlTime.FromSeconds(end)))));
            Report(cell);
            Until(cell, end + 0.2);

            Assert.That((StateOf(cell), cell.Session.Frames.HeldSince(Find(cell, "box"))), Is.EqualTo((PoseState.Current, (ControlTime?)null)));
        }

        // The gripper may have carried the box away, and its source does not report this.
        [TestCase(0)]
        [TestCase(0.001)]
        public void StateOf_GripperClosedBeforeTheFirstSample_IsHeldUntilTheSourceReportsAnotherPose(double noise)
        {
            var random = new Random(1);
            var (cell, _) = NewGrip();
            var x = 1.05;
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(x + noise * random.NextNormal(), 0.02));
            };
            cell.Send("grip", 5, 1);
            Until(cell, Close);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held), "the box may be in the gripper");

            cell.Send("grip", Close, 0);
            Until(cell, Close + 1);
            Assert.That((StateOf(cell), cell.Session.Frames.HeldSince(Find(cell, "box"))),
                Is.EqualTo((PoseState.Held, (ControlTime?)ControlTime.FromSeconds(Close))), "the box may be where the gripper released it");

            x = 1.1;
            Until(cell, Close + 2);

            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        [TestCase(Close)]
        [TestCase(20.4, Description = "Less than 12 samples have arrived.")]
        public void StateOf_SourceMovesTheObjectDuringAnUnknownGrip_IsCurrentAfterTheOpening(double open)
        {
            var (cell, _) = NewGrip();
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(t < open - 0.2 ? 1.05 : 1.15, 0.02));
            };
            cell.Send("grip", 5, 1);
            Until(cell, open);

            cell.Send("grip", open, 0);
            Until(cell, open + 1);

            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void StateOf_GrippedAfterAnUnknownGrip_IsCurrent()
        {
            var (cell, grip) = NewGrip();
            cell.Send("grip", 5, 1);
            Until(cell, 21);
            cell.Send("grip", 21, 0);
            Until(cell, Close);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));

            cell.Send("grip", Close, 1);
            Until(cell, Close + 1);

            Assert.That((grip.Held, StateOf(cell)), Is.EqualTo(("box", PoseState.Current)));
        }

        // The arm stops short of the box. Until its samples show this, the prediction has it at the box.
        [Test]
        public void StateOf_GripIsWithdrawnAfterAnUnknownGrip_IsStillHeld()
        {
            const double stop = Close - 0.1;
            var (cell, grip) = NewGrip();
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Math.Min(0, t - stop) - 0.14, 0);
                cell.Send("world", "box", t, At(1, 0));
            };
            cell.Send("grip", 5, 1);
            Until(cell, 21);
            cell.Send("grip", 21, 0);
            Until(cell, Close - 0.03);
            SendGripNow(cell, Close - 0.03, 1);
            Until(cell, Close);
            Assert.That(grip.Held, Is.EqualTo("box"));

            Until(cell, Close + 1);

            Assert.That((grip.Held, StateOf(cell)), Is.EqualTo(((string)null, PoseState.Held)));
        }

        [Test]
        public void StateOf_SignalRestartsWhileTheGripperIsClosed_IsHeld()
        {
            var (cell, _) = NewGrip();
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 1);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));

            for (var t = Close + 1; t < Close + 2; t += 0.05)
            {
                cell.Send("grip", t - 10, 1);
                Until(cell, t + 0.05);
            }

            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));
        }

        [Test]
        public void StateOf_NoValueOfTheSignal_IsHeldOnlyForObjectsThatTheGripperCanHold()
        {
            var (cell, _) = NewGrip("part", "cart", "table");
            cell.Send("tool_centre_point", "part", 20, At(0, 0), isStationary: true);
            cell.Send("world", "cart", 20, At(0, 0), isStationary: true);
            cell.Send("cart", "base", 20, At(0, 0), isStationary: true);
            cell.Send("world", "table", 20, At(9, 0), isStationary: true);

            Until(cell, Close);

            Assert.That((StateOf(cell), StateOf(cell, "table")), Is.EqualTo((PoseState.Held, PoseState.Held)));
            Assert.That(StateOf(cell, "part"), Is.EqualTo(PoseState.Current), "its source reports that the robot carries it");
            Assert.That(StateOf(cell, "cart"), Is.EqualTo(PoseState.Current), "the robot stands on it");
        }

        // Its component is enabled later. The poses from the time of the closing are known, because another component shows the object.
        [TestCase(5, PoseState.Current)]
        [TestCase(1.05, PoseState.Held)]
        public void StateOf_ObjectCanBeGrippedAfterTheClosing_IsHeldOnlyIfItWasWithinReach(double x, PoseState expected)
        {
            var cell = new CellSession();
            var objects = new List<string>();
            GripScene.NewGrip(cell, objects);
            cell.Session.Frames.Need("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(x, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 3);

            objects.Add("box");
            Until(cell, Close + 4);

            Assert.That(StateOf(cell), Is.EqualTo(expected));
        }

        [Test]
        public void Remove_GripperWithoutAValue_ObjectsAreCurrent()
        {
            var (cell, grip) = NewGrip();
            Until(cell, Close);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));

            cell.Session.Grips.Remove(grip);
            Until(cell, Close + 0.1);

            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        // A menu hides the gripper while or after it may have carried the box away.
        [Test]
        public void Remove_GripperDuringOrAfterAnUnknownGrip_ObjectIsHeldUntilTheSourceReportsAnotherPose([Values] bool hasOpened)
        {
            var (cell, grip) = NewGrip();
            var x = 1.05;
            cell.Sampling = t =>
            {
                if (t > 20) cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(x, 0.02));
            };
            cell.Send("grip", 5, 1);
            Until(cell, Close);
            if (hasOpened) cell.Send("grip", Close, 0);
            Until(cell, Close + 1);

            cell.Session.Grips.Remove(grip);
            Until(cell, Close + 2);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));

            x = 1.1;
            Until(cell, Close + 3);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        static (CellSession Cell, ReachGrip Grip) NewGrip(params string[] others)
        {
            var objects = new string[others.Length + 1];
            objects[0] = "box";
            others.CopyTo(objects, 1);
            var (cell, grip) = NewCell(objects);
            cell.Sampling = t =>
            {
                if (t > 20) cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(1.05, 0.02));
            };
            return (cell, grip);
        }

        static PoseState StateOf(CellSession cell, string frame = "box") => cell.Session.Frames.StateOf(Find(cell, frame));

        static void Report(CellSession cell, params JointReport[] reports) =>
            cell.Session.Listener.SignalStatusReceived(new JointStatusMessage(reports), HeadsetTime.FromSeconds(cell.Now));
    }
}
