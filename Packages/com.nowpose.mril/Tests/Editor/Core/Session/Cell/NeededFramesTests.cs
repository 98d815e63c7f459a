using System.Collections.Generic;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests the kept poses of frames that are not shown yet.</summary>
    public class NeededFramesTests
    {
        // Newer messages overtake a message by up to 0.25 s. An older pose shows that the source has restarted.
        [TestCase(0.2, 20)]
        [TestCase(5, 15)]
        public void Need_OlderPoseArrivedLast_IsUsedIfItsSourceHasRestarted(double older, double expected)
        {
            var cell = new CellSession();
            Receive(cell, 20, false, "box");
            Receive(cell, 20 - older, false, "box");
            cell.Run(0.1);

            cell.Session.Frames.Need("box");

            Assert.That(cell.Session.Frames.Find("box").Newest, Is.EqualTo((ControlTime?)ControlTime.FromSeconds(expected)));
        }

        // The limits of the tree are checked only when a frame is shown.
        [Test]
        public void Need_KeptPosesFormACycle_CountsTheRefusedPose()
        {
            var cell = new CellSession();
            cell.Send("b", "a", 20, At(1, 0), isStationary: true);
            cell.Send("a", "b", 20, At(1, 0), isStationary: true);
            cell.Run(0.1);
            Assert.That(cell.Session.Drops.Total, Is.Zero);

            cell.Session.Frames.Need("a");

            Assert.That((cell.Session.Drops[DropReason.FrameCycle], cell.Session.Drops.Total), Is.EqualTo((1L, 1L)));
        }

        // A stationary pose is sent only once and has no time of its own.
        [TestCase(9, 1)]
        [TestCase(11, 0)]
        public void Add_StationaryFrameAndTooManyTrackedFrames_ReplacesASilentFrame(double silentSeconds, int dropped)
        {
            var cell = new CellSession();
            Receive(cell, 20, false, Enumerable.Range(0, ProtocolLimits.Frames).Select(i => "old" + i).ToArray());
            cell.Run(silentSeconds);

            Receive(cell, 0, true, "fixture");
            cell.Run(0.1);
            cell.Session.Frames.Need("fixture");

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames], Is.EqualTo(dropped));
            Assert.That(cell.Session.Frames.Find("fixture"), dropped == 0 ? Is.Not.Null : Is.Null);
        }

        // An application creates an object for each serial number, and destroys it later.
        [Test]
        public void Leave_FramesOfFormerObjects_AreReplacedByNewOnes()
        {
            var cell = new CellSession();
            Receive(cell, 0, true, "conveyor");
            for (var i = 0; i < 40; i++)
            {
                var (box, stamp) = ("box" + i, cell.Now);
                cell.Session.Frames.Need(box);
                cell.Send("conveyor", box, stamp, At(1, 0));
                cell.Run(1);
                Assert.That(cell.Session.Frames.Find(box)?.World.X, Is.EqualTo(2), box);
                cell.Session.Frames.Leave(box);
            }

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames], Is.Zero);
            Assert.That(cell.Session.Frames.Tree.Count, Is.LessThan(16));
            Assert.That(cell.Session.Frames.Find("conveyor"), Is.Not.Null, "the parent of objects is kept");
        }

        // The signal of the gripper is not published, so it may hold any of the objects.
        [Test]
        public void Leave_FormerObjectsOfAGripperWithoutASignal_AreReplacedByNewOnes()
        {
            var cell = new CellSession();
            var objects = new List<string>();
            NewGrip(cell, objects);
            for (var i = 0; i < 40; i++)
            {
                var box = "box" + i;
                objects.Add(box);
                cell.Session.Frames.Need(box);
                cell.Send("world", box, cell.Now, At(1, 0));
                cell.Run(1);
                Assert.That(Find(cell, box), Is.Not.Null, box);
                objects.Remove(box);
                cell.Session.Frames.Leave(box);
            }

            Assert.That(cell.Session.Frames.Tree.Count, Is.LessThan(16));
        }

        // For example, a vision system publishes each part once, under a name of its own.
        [Test]
        public void Leave_StationaryFramesOfFormerObjects_AreReplacedWhenTheTreeIsFull()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("shown");
            Receive(cell, 0, true, "shown", "carrier");
            for (var i = 0; i < 300; i++)
            {
                var part = "part" + i;
                cell.Session.Frames.Need(part);
                cell.Send("carrier", part, 0, At(1, 0), isStationary: true);
                cell.Run(0.05);
                Assert.That(Find(cell, part)?.World.X, Is.EqualTo(2), part);
                cell.Session.Frames.Leave(part);
            }

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames], Is.Zero);
            Assert.That((Find(cell, "shown")?.World.X, Find(cell, "carrier")?.World.X), Is.EqualTo(((double?)1.0, (double?)1.0)));
        }

        [TestCase(1, 1)]
        [TestCase(2, 2)]
        [TestCase(2, 1)]
        public void Leave_FrameStillShownOrSending_IsKept(int needs, int leaves)
        {
            var isSending = needs == leaves;
            var cell = new CellSession();
            cell.Sampling = t =>
            {
                if (isSending || t < 21) cell.Send("world", "box", t, At(1, 0));
            };
            for (var i = 0; i < needs; i++) cell.Session.Frames.Need("box");
            cell.Run(1);
            var shown = cell.Session.Frames.Find("box");

            for (var i = 0; i < leaves; i++) cell.Session.Frames.Leave("box");
            cell.Run(15);
            ShowAnother(cell);

            Assert.That(cell.Session.Frames.Find("box"), Is.SameAs(shown));
        }

        // The tracker has lost the object in the gripper, and nothing shows it for a while.
        [Test]
        public void Leave_ObjectInAGripper_IsKept()
        {
            var (cell, _) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                if (t < Close + 0.5) cell.Send("world", "box", t, At(1, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 1);
            var gripped = Find(cell, "box");
            Assert.That(gripped.Reach?.IsReleased, Is.False);

            cell.Session.Frames.Leave("box");
            Until(cell, Close + 15);
            ShowAnother(cell);

            Assert.That(Find(cell, "box"), Is.SameAs(gripped));
        }

        [Test]
        public void Add_TheNewParentOfAnObject_DoesNotReplaceTheFormerOneBeforeTheChange()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            Receive(cell, 0, true, "fixture");
            cell.Sampling = t =>
            {
                if (t < 21) cell.Send("world", "shuttle", t, At(3, 0));
                if (t < 32) cell.Send("shuttle", "box", t, At(1, 0));
            };
            Until(cell, 32);

            cell.Send("fixture", "box", cell.Now, At(3, 0));
            cell.Run(1, t => Assert.That(Find(cell, "box").World.X, Is.EqualTo(4).Within(1e-6), $"{t} s"));
            Assert.That(Find(cell, "shuttle"), Is.Not.Null);
        }

        [Test]
        public void Add_OneUnusedFrameAndTooManyOthers_DropsAllButOne()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            cell.Send("world", "box", cell.Now, At(1, 0));
            cell.Run(1);
            cell.Session.Frames.Leave("box");
            cell.Run(15);

            foreach (var name in new[] { "fixture", "table" })
                Receive(cell, 0, true, Enumerable.Range(0, ProtocolLimits.Frames / 2 + 2).Select(i => name + i).ToArray());
            cell.Run(1);

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames], Is.EqualTo(4));
        }

        // A gateway that has restarted may have other frames. It sends all of its frames at once.
        [TestCase(true, 0)]
        [TestCase(false, 1)]
        public void Add_StationaryFrameAndTooManyFromBeforeTheConnection_ReplacesOneOfThem(bool isNewConnection, int dropped)
        {
            var cell = new CellSession();
            cell.Reconnect();
            Receive(cell, 0, true, Enumerable.Range(0, ProtocolLimits.Frames).Select(i => "old" + i).ToArray());
            cell.Run(1);

            if (isNewConnection) cell.Reconnect();
            Receive(cell, 0, true, "fixture");
            cell.Run(0.1);
            cell.Session.Frames.Need("fixture");

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames], Is.EqualTo(dropped));
            Assert.That(Find(cell, "fixture"), dropped == 0 ? Is.Not.Null : Is.Null);
        }

        // For example, a source that numbers the carriers of an object.
        [Test]
        public void Add_FrameWithAnotherParent_FormerParentIsNotNeeded()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            cell.Send("carrier1", "box", cell.Now, At(1, 0), isStationary: true);
            cell.Run(0.1);
            cell.Send("carrier2", "box", cell.Now, At(1, 0), isStationary: true);
            cell.Run(0.1);

            Receive(cell, 0, true, "carrier1", "carrier2");
            cell.Run(0.1);

            Assert.That((Find(cell, "carrier1"), Find(cell, "carrier2")?.World.X), Is.EqualTo(((CellFrame)null, (double?)1)));
            Assert.That(Find(cell, "box").World.X, Is.EqualTo(2));
        }

        static void ShowAnother(CellSession cell)
        {
            cell.Session.Frames.Need("other");
            cell.Send("world", "other", cell.Now, At(1, 0));
            cell.Run(1);
            Assert.That(Find(cell, "other"), Is.Not.Null);
        }

        static void Receive(CellSession cell, double stamp, bool isStationary, params string[] frames) => cell.Session.Listener.FramesReceived(
            new TransformsMessage(frames.Select(frame => At(1, 0).ToTransform(ControlTime.FromSeconds(stamp), "world", frame)).ToArray()),
            isStationary, HeadsetTime.FromSeconds(cell.Now));
    }
}
