using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>
    /// Tests objects that no source attaches to the gripper. The gripper takes the nearest object within its reach at the stamp of its
    /// signal.
    /// </summary>
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
                Assert.That(Distance(inHand, expected), Is.LessThan(1e-6), "the pose in the tool is that at the stamp");
                Assert.That(AngleOf(inHand, expected), Is.LessThan(1e-6));
                Assert.That(cell.Session.Frames.StateOf(Find(cell, "box")), Is.EqualTo(PoseState.Current));
                Assert.That(Find(cell, "far").Parent, Is.EqualTo("world"));
            });
        }

        [Test]
        public void Close_SeveralObjectsInReach_TakesTheNearestAtTheStamp()
        {
            var (cell, grip) = NewCell("left", "right");
            // The left object becomes the nearest one while the message of the signal is in flight.
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

            // At the stamp, the left object is 0.04 m from the tool and the right object 0.028 m.
            Assert.That(grip.Held, Is.EqualTo("right"));
        }

        [Test]
        public void Close_MotionChangesAfterTheStamp_HasTheSameResultOnEveryHeadset()
        {
            // The belt stops at the stamp, but the prediction continues its motion. Therefore the pose that is displayed at first depends on
            // the latency, but the final pose depends only on the samples.
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
        public void CloseAndOpen_DisplayedObject_DoesNotJump()
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
                Assert.That(Distance(before, box), Is.LessThan(0.007),
                    "the tool moves 5.3 mm per frame (0.3 rad/s · 1.05 m / 60 Hz), and a correction fades out");
                before = box;
            });
            Assert.That(Distance(before, At(1.05, 0.02)), Is.GreaterThan(0.5));
        }

        [Test]
        public void Open_ObjectHeld_StaysAtTheToolPoseOfTheStamp()
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
                Assert.That(Distance(Find(cell, "box").World, Tool(Shoulder(Open))), Is.LessThan(1e-6), "the object stays although its source repeats the old pose");
                Assert.That(cell.Session.Frames.StateOf(Find(cell, "box")), Is.EqualTo(PoseState.Current));
            });
        }

        [Test]
        public void Open_SourceMovesTheObjectAfterwards_FollowsTheSource()
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
        public void Close_SourceAttachesTheObjectToTheTool_FollowsTheSource()
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

            Assert.That(grip.Held, Is.Null, "the gripper does not hold an object that its source attaches to the tool");
            Assert.That(Distance(ToolOf(cell).Inverse * Find(cell, "box").World, At(0.01, 0)), Is.LessThan(1e-9));
        }

        [Test]
        public void Close_NothingInReach_HoldsNothingAndReportsNoFault()
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
        public void Close_BeforeTheFirstSample_ReportsAFault()
        {
            var (cell, grip) = NewCell("box");
            cell.Send("world", "box", 20, At(1, 0), isStationary: true);
            cell.Sampling = t => { if (t > 20) cell.SendJoints(t, 0, 0); };
            cell.Send("grip", 5, 1);
            Until(cell, Close);

            Assert.That(grip.Held, Is.Null);
            Assert.That(grip.Fault, Is.EqualTo(FrameMessages.ArmWithoutData));

            cell.Send("grip", Close, 0);
            Until(cell, Close + 1);
            Assert.That(grip.Fault, Is.Null);
        }

        [Test]
        public void Close_RobotStandsOnTheObject_DoesNotTakeTheObject()
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
        public void Remove_HeldObject_FollowsItsSourceAndIsNotCurrentUntilAnotherPose()
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
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held), "the box moves with the real gripper");
            cell.Send("world", "box", 0, At(2, 0), isStationary: true);
            Until(cell, Close + 3);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void HeldOf_GrippedObject_IsInTheUncompensatedTool()
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
