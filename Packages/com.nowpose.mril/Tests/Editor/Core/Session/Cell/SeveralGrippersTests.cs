using System;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    public class SeveralGrippersTests
    {
        [Test]
        public void Close_SecondGripper_TakesTheObjectFromTheFirst()
        {
            var (cell, first) = NewCell("box");
            var robot = cell.Session.Robots[0];
            var second = new ReachGrip(cell.Session.Frames.Tree, robot, robot.Robot.IndexOfLink("base"), 2, new[] { "box" });
            cell.Session.Grips.Add(second, "other");
            cell.Send("world", "box", 20, At(1, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 1);
            var taken = cell.Now;
            cell.Send("other", taken, 1);
            Until(cell, taken + 0.5);
            cell.Send("grip", cell.Now, 0);
            Until(cell, taken + 1.5);

            Assert.That(first.Held, Is.Null);
            Assert.That(second.Held, Is.EqualTo("box"));
            Assert.That(Distance(Find(cell, "box").World, Tool(Shoulder(taken))), Is.LessThan(1e-6));
        }

        // All headsets must show the object in the same gripper, although the messages arrive in another order.
        [TestCase(0, 0.1)]
        [TestCase(0.1, 0)]
        [TestCase(0.1, 0.1)]
        public void Close_TwoGrippers_TheOneThatClosedLastHoldsTheObject(double firstDelay, double secondDelay)
        {
            var (cell, first) = NewCell("box");
            var robot = cell.Session.Robots[0];
            var second = new ReachGrip(cell.Session.Frames.Tree, robot, robot.Robot.IndexOfLink("base"), 2, new[] { "box" });
            cell.Session.Grips.Add(second, "other");
            cell.Send("world", "box", 20, At(1, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, 0, 0);
            cell.Send("grip", 19, 0);
            cell.Send("other", 19, 0);
            Until(cell, Close + 0.1);

            foreach (var (delay, signal, stamp) in new[] { (firstDelay, "grip", Close), (secondDelay, "other", Close + 0.05) }.OrderBy(one => one.Item1))
            {
                Until(cell, Close + 0.1 + delay);
                cell.Send(signal, stamp, 1);
            }
            Until(cell, Close + 2);

            Assert.That((first.Held, second.Held), Is.EqualTo(((string)null, "box")));
        }

        // The second arm stops short of the box. Until its samples show this, the prediction has it at the box.
        [TestCase(0.02)]
        [TestCase(0.08)]
        public void Close_SecondGripperMissesAndTheFirstOpens_ObjectIsWhereTheFirstReleasedIt(double openAfter)
        {
            var (cell, first, second) = CloseBeside();

            Until(cell, HandOver + openAfter + 0.02);
            Assert.That(second.Held, Is.EqualTo("box"));
            SendNow(cell, "grip", HandOver + openAfter, 0);
            Until(cell, HandOver + 1.5);

            Assert.That((first.Held, second.Held, StateOf(cell)), Is.EqualTo(((string)null, (string)null, PoseState.Current)));
            Assert.That(Distance(Find(cell, "box").World, Tool(Carried)), Is.LessThan(1e-6));
        }

        [Test]
        public void Close_SecondGripperMissesAndTheFirstIsRemoved_ObjectIsNotCurrentAndFollowsItsSource()
        {
            var (cell, first, second) = CloseBeside();

            Until(cell, HandOver + 0.08);
            Assert.That(second.Held, Is.EqualTo("box"));
            cell.Session.Grips.Remove(first);
            Until(cell, HandOver + 1.5);

            Assert.That((second.Held, StateOf(cell)), Is.EqualTo(((string)null, PoseState.Held)));
            Assert.That(Distance(Find(cell, "box").World, At(1, 0)), Is.LessThan(1e-6));
        }

        // The signals of the grippers come from two sources. The first arm opens and moves away, then the second one closes at the same place.
        [Test]
        public void Close_ReleaseByTheFirstGripperArrivesLater_ObjectIsHeldAtThePlaceOfTheRelease(
            [Values(0, 0.3, 0.6)] double delay, [Values(0.4, 1.5)] double speed)
        {
            const double open = HandOver - 0.2;
            var (cell, first, second) = NewArms();
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Math.Max(0, Math.Min(0.6, speed * (t - open - 0.05))), 0);
                cell.SendJoints(t, -0.02 - Math.Max(0, Math.Min(0.6, t - HandOver - 0.05)), 0, "arm2");
                cell.Send("world", "box", t, At(1, 0));
            };
            Until(cell, Close);
            SendNow(cell, "grip", Close, 1);
            Until(cell, HandOver + 0.06);
            if (delay == 0) SendNow(cell, "grip", open, 0);
            SendNow(cell, "second", HandOver, 1);
            Until(cell, HandOver + 0.06 + delay);
            if (delay > 0) SendNow(cell, "grip", open, 0);
            Until(cell, HandOver + 2);

            Assert.That((first.Held, second.Held, StateOf(cell)), Is.EqualTo(((string)null, "box", PoseState.Current)));
            Assert.That(Distance(Find(cell, "box").Held, Tool(-0.02).Inverse * At(1, 0)), Is.LessThan(1e-3));
        }

        /// <summary>Stamp of the closing of the second arm's gripper, s.</summary>
        const double HandOver = 24.01;

        /// <summary>Shoulder angle to which the first arm carries the box, rad.</summary>
        const double Carried = 0.3;

        // Closes the gripper of a second arm 0.14 m beside the box that the first arm holds. The first arm moves on 0.3 s later. The samples of the joints
        // arrive 150 ms late.
        static (CellSession Cell, ReachGrip First, ReachGrip Second) CloseBeside()
        {
            var (cell, first, second) = NewArms();
            cell.Sampling = t =>
            {
                var stamp = t - 0.09;
                cell.SendJoints(stamp, Math.Max(0, Math.Min(Carried, Carried * (stamp - Close - 0.5)) - Math.Max(0, stamp - HandOver - 0.3)), 0);
                cell.SendJoints(stamp, Carried - 0.14 - Math.Max(0, HandOver - 0.1 - stamp), 0, "arm2");
                cell.Send("world", "box", t, At(1, 0));
            };
            Until(cell, Close);
            SendNow(cell, "grip", Close, 1);
            Until(cell, HandOver + 0.02);
            Assert.That(first.Held, Is.EqualTo("box"));
            SendNow(cell, "second", HandOver, 1);
            return (cell, first, second);
        }

        static (CellSession Cell, ReachGrip First, ReachGrip Second) NewArms()
        {
            var (cell, first) = NewCell("box");
            var arm = cell.Session.Robots.Add("arm2", TestRobot.Model);
            var second = new ReachGrip(cell.Session.Frames.Tree, arm, arm.Robot.IndexOfLink("tool_centre_point"), Reach, new[] { "box" });
            cell.Session.Grips.Add(second, "second");
            cell.Send("grip", 19, 0);
            cell.Send("second", 19, 0);
            return (cell, first, second);
        }
    }
}
