using System.Linq;
using Nowpose.Frames;
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
    }
}
