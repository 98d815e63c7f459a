using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Objects that no source attaches to the gripper: its reach at the stamp of its signal decides.</summary>
    public class SessionGripsTests
    {
        [Test]
        public void Close_ObjectInReach_MovesWithTheDisplayedTool([Values(0, 1)] int isStationary)
        {
            var (cell, grip) = NewCell("box", "far");
            if (isStationary == 1) cell.Send("world", "box", 20, At(1.05, 0.02), isStationary: true);
            cell.Send("world", "far", 20, At(1.2, 0), isStationary: true);
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                if (isStationary == 0) cell.Send("world", "box", t, At(1.05, 0.02));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close - 0.5);
            cell.Send("grip", Close, 1);

            Until(cell, Close - CellSession.Visu - 0.02, _ => Assert.That(grip.Held, Is.Null));
            Assert.That(Distance(Find(cell, "box").World, At(1.05, 0.02)), Is.LessThan(1e-6));
            Until(cell, Close + 0.2);

            Until(cell, Close + 1.5, light =>
            {
                Assert.That(grip.Held, Is.EqualTo("box"));
                var inHand = ToolOf(cell).Inverse * Find(cell, "box").World;
                var expected = Tool(0).Inverse * At(1.05, 0.02);
                Assert.That(Distance(inHand, expected), Is.LessThan(1e-6), "as it was at the stamp, in the tool");
                Assert.That(AngleOf(inHand, expected), Is.LessThan(1e-6));
                Assert.That(cell.Session.Frames.StateOf(Find(cell, "box")), Is.EqualTo(PoseState.Current));
                Assert.That(Find(cell, "far").Parent, Is.EqualTo("world"));
            });
        }

        [Test]
        public void Close_SeveralObjectsInReach_TakesTheNearestAtTheStamp()
        {
            var (cell, grip) = NewCell("left", "right");
            // The nearer object changes while the message about the signal is on its way.
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                cell.Send("world", "left", t, At(1.05 - 0.2 * (t - Close + 0.1), 0));
                cell.Send("world", "right", t, At(0.98, 0.02));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close - 0.05, 1);
            Until(cell, Close + 0.5);

            // At the stamp: left at 0.04, right at 0.028.
            Assert.That(grip.Held, Is.EqualTo("right"));
        }

        [Test]
        public void Close_MotionChangesAfterTheStamp_HasTheSameResultOnEveryHeadset()
        {
            // The belt stops at the stamp. Prediction continues, so what is displayed first depends on the latency; the samples do not.
            double X(double t) => 1.02 + 0.5 * (Math.Min(t, Close) - Close);
            var poses = new RigidTransform[2];
            for (var headset = 0; headset < 2; headset++)
            {
                var (cell, grip) = NewCell("box");
                var isLate = headset == 1;
                cell.Sampling = t =>
                {
                    var stamp = isLate ? t - 0.1 : t;
                    cell.SendJoints(stamp, Shoulder(Math.Max(stamp, Close)), 0);
                    cell.Send("world", "box", stamp, At(X(stamp), 0));
                };
                cell.Send("grip", 19, 0);
                Until(cell, Close - 0.3);
                cell.Send("grip", Close, 1);
                Until(cell, Close + 1);
                Assert.That(grip.Held, Is.EqualTo("box"));
                poses[headset] = ToolOf(cell).Inverse * Find(cell, "box").World;
            }

            Assert.That(Distance(poses[0], At(0.02, 0)), Is.LessThan(1e-6));
            Assert.That(Distance(poses[0], poses[1]), Is.LessThan(1e-9));
        }

        [Test]
        public void Close_Displayed_JumpsNeitherAtTheGripNorAtTheRelease()
        {
            var (cell, _) = NewCell("box");
            cell.Send("world", "box", 20, At(1.05, 0.02), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);
            cell.Send("grip", 19, 0);
            Until(cell, Close - 0.3);
            cell.Send("grip", Close, 1);
            cell.Send("grip", Open, 0);
            var before = Find(cell, "box").World;

            Until(cell, Open + 1, _ =>
            {
                var box = Find(cell, "box").World;
                Assert.That(Distance(before, box), Is.LessThan(0.007), "0.3 rad/s · 1.05 m · 1/60 s is 5.3 mm, and such a difference fades out");
                before = box;
            });
            Assert.That(Distance(before, At(1.05, 0.02)), Is.GreaterThan(0.5));
        }

        [Test]
        public void Open_ObjectHeld_StaysWhereTheToolWasAtTheStamp()
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(1, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Open - 0.2);
            cell.Send("grip", Open, 0);
            Until(cell, Open + 0.5);

            Until(cell, Open + 1, _ =>
            {
                Assert.That(grip.Held, Is.Null);
                Assert.That(Distance(Find(cell, "box").World, Tool(Shoulder(Open))), Is.LessThan(1e-6), "although its source repeats the old pose");
                Assert.That(cell.Session.Frames.StateOf(Find(cell, "box")), Is.EqualTo(PoseState.Current));
            });
        }

        [Test]
        public void Open_SourceMovesTheObjectAfterwards_SourceDecides()
        {
            var (cell, _) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, t < Open + 0.5 ? At(1, 0) : At(-1, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Open);
            cell.Send("grip", Open, 0);

            Until(cell, Open + 1.5);

            Assert.That(Distance(Find(cell, "box").World, At(-1, 0)), Is.LessThan(1e-6));
            Assert.That(Find(cell, "box").Parent, Is.EqualTo("world"));
        }

        [Test]
        public void Close_SourceGivesTheObjectAParent_SourceDecides()
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                if (t < Close) cell.Send("world", "box", t, At(1, 0));
                else cell.Send("tool_centre_point", "box", t, At(0.01, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close - 0.1);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 1);

            Assert.That(grip.Held, Is.Null, "it is held by its source");
            Assert.That(Distance(ToolOf(cell).Inverse * Find(cell, "box").World, At(0.01, 0)), Is.LessThan(1e-9));
        }

        [Test]
        public void Close_NothingInReach_HoldsNothingWithoutAFault()
        {
            var (cell, grip) = NewCell("box");
            cell.Send("world", "box", 20, At(1 + Reach + 0.001, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, 0, 0);
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 2);

            Assert.That(grip.Held, Is.Null);
            Assert.That(grip.Fault, Is.Null);
        }

        [Test]
        public void Close_BeforeTheSessionHadSamples_IsUnknown()
        {
            var (cell, grip) = NewCell("box");
            cell.Send("world", "box", 20, At(1, 0), isStationary: true);
            cell.Sampling = t => { if (t > 20) cell.SendJoints(t, 0, 0); };
            cell.Send("grip", 5, 1);
            Until(cell, Close);

            Assert.That(grip.Held, Is.Null);
            Assert.That(grip.Fault, Does.Contain("held object is unknown"));

            cell.Send("grip", Close, 0);
            Until(cell, Close + 1);
            Assert.That(grip.Fault, Is.Null);
        }

        [Test]
        public void Close_TwoGrippers_TheLastOneTakesTheObjectFromTheFirst()
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

        [Test]
        public void Close_RobotStandsOnTheObject_IsNotTaken()
        {
            var (cell, grip) = NewCell("cart");
            cell.Sampling = t => cell.SendJoints(t, 0, 0);
            cell.Send("world", "cart", 20, At(1, 0), isStationary: true);
            cell.Send("cart", "base", 20, At(-1, 0), isStationary: true);
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 2);

            Assert.That(grip.Held, Is.Null);
            Assert.That(Find(cell, "cart").Parent, Is.EqualTo("world"));
        }

        [Test]
        public void Remove_HeldObject_IsGivenBackToItsSource()
        {
            var (cell, grip) = NewCell("box");
            cell.Send("world", "box", 20, At(1, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 1);
            Assert.That(grip.Held, Is.EqualTo("box"));

            cell.Session.Grips.Remove(grip);
            Until(cell, Close + 2);

            Assert.That(Distance(Find(cell, "box").World, At(1, 0)), Is.LessThan(1e-9));
        }

        [Test]
        public void Held_OfGrippedObject_IsInTheUncompensatedTool()
        {
            var (cell, _) = NewCell("box");
            cell.Send("world", "box", 20, At(1.05, 0), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 1);

            var newest = cell.Session.Robots[0].Frame.HeldJoints[0];
            var held = cell.Session.Frames.Tree.HeldOf(cell.Session.Frames.Tree.IndexOf("box"));
            Assert.That(Distance(held, Tool(newest) * At(0.05, 0)), Is.LessThan(1e-9));
            Assert.That(Distance(held, Find(cell, "box").World), Is.GreaterThan(0.02), "0.1 s at 0.3 m/s");
        }
    }
}
