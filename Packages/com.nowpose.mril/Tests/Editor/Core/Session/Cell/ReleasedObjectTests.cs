using Nowpose.Frames;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
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
