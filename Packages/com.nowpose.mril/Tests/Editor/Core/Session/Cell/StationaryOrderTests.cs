using System.Linq;
using Nowpose.Frames;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests stationary frames whose parents change within one message or one display frame.</summary>
    public class StationaryOrderTests
    {
        static readonly string[] Chain = { "world", "a", "b", "c" };

        // Each order of the message must have the same result, although it gives some frames a parent that is still below them.
        [Test]
        public void Add_ChainIsReversedInOneMessage_AllFramesAreUsed([Values("abc", "acb", "bac", "bca", "cab", "cba")] string order)
        {
            var cell = new CellSession();
            foreach (var name in Chain.Skip(1)) cell.Session.Frames.Need(name);
            Receive(cell, Pose("world", "a", 1), Pose("a", "b", 1), Pose("b", "c", 1));
            Assert.That(Find(cell, "c").World.X, Is.EqualTo(3));

            Receive(cell, order.Select(frame => frame == 'c' ? Pose("world", "c", 5) : frame == 'b' ? Pose("c", "b", 1) : Pose("b", "a", 1)).ToArray());

            Assert.That((Find(cell, "c").World.X, Find(cell, "b").World.X, Find(cell, "a").World.X), Is.EqualTo((5.0, 6.0, 7.0)));
            Assert.That(cell.Session.Drops.Total, Is.Zero);
        }

        [Test]
        public void Add_CycleInOneMessage_CountsTheRefusedFrameOnce()
        {
            var cell = new CellSession();
            foreach (var name in Chain.Skip(1)) cell.Session.Frames.Need(name);

            Receive(cell, Pose("b", "a", 1), Pose("a", "b", 1), Pose("world", "c", 1));

            Assert.That((cell.Session.Drops[DropReason.FrameCycle], cell.Session.Drops.Total), Is.EqualTo((1L, 1L)));
            Assert.That(Find(cell, "c"), Is.Not.Null);
        }

        // Both messages wait for the same display frame. Until the first one, b is on a.
        [Test]
        public void Add_FrameIsPutOnATrackedFrameThatHasLeftIt_IsUsed()
        {
            var cell = new CellSession();
            foreach (var name in Chain.Skip(1)) cell.Session.Frames.Need(name);
            Receive(cell, Pose("world", "a", 1));
            cell.Send("a", "b", cell.Now - 0.2, At(1, 0));
            cell.Run(0.1);
            Assert.That(Find(cell, "b").World.X, Is.EqualTo(2));

            cell.Send("world", "b", cell.Now - 0.1, At(5, 0));
            Receive(cell, Pose("b", "a", 1));

            Assert.That((Find(cell, "b").World.X, Find(cell, "a").World.X), Is.EqualTo((5.0, 6.0)));
            Assert.That(cell.Session.Drops.Total, Is.Zero);
        }

        // No frame is computed while another source repeats its pose, for example because the program loads a scene.
        [Test]
        public void Add_OtherSourceFillsTheQueue_PoseThatIsSentOnceIsUsed([Values] bool isStationary)
        {
            var cell = new CellSession(isClockKnown: false);
            foreach (var name in new[] { "once", "repeated" }) cell.Session.Frames.Need(name);
            cell.Send("world", "once", 18, At(7, 0), isStationary);
            for (var k = 0; k < 1500; k++) cell.Send("world", "repeated", 18 + 0.001 * k, At(k, 0), isStationary);

            cell.Synchronise();
            cell.Run(0.1);

            Assert.That(Find(cell, "once")?.World.X, Is.EqualTo(7));
            Assert.That(Find(cell, "repeated").Held.X, Is.EqualTo(1499));
        }

        static FrameTransform Pose(string parent, string child, double x) => At(x, 0).ToTransform(default, parent, child);

        static void Receive(CellSession cell, params FrameTransform[] poses)
        {
            cell.Session.Listener.FramesReceived(new TransformsMessage(poses), true, HeadsetTime.FromSeconds(cell.Now));
            cell.Run(0.5);
        }
    }
}
