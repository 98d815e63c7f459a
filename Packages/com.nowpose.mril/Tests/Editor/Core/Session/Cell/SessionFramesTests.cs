using System;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    public class SessionFramesTests
    {
        static RigidTransform Along(double x) => RigidTransform.FromXyzRpy(x, 0, 0, 0, 0, 0);

        static double Distance(in RigidTransform a, in RigidTransform b) =>
            Math.Sqrt((a.X - b.X) * (a.X - b.X) + (a.Y - b.Y) * (a.Y - b.Y) + (a.Z - b.Z) * (a.Z - b.Z));

        [Test]
        public void Frame_ConstantSpeed_IsShownAtThePoseOfTheDisplayTime()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            cell.Sampling = t => cell.Send("world", "box", t, RigidTransform.FromXyzRpy(0.2 * t, 0, 0, 0, 0, 0.5 * t));
            cell.Run(1);

            cell.Run(1, light =>
            {
                var box = cell.Session.Frames.Find("box");
                var truth = RigidTransform.FromXyzRpy(0.2 * light, 0, 0, 0, 0, 0.5 * light);
                Assert.That(Distance(box.World, truth), Is.LessThan(1e-6));
                Assert.That(UnitQuaternion.Of(box.World.Inverse * truth).Log().Length, Is.LessThan(1e-6));
                Assert.That(cell.Session.Frames.StateOf(box), Is.EqualTo(PoseState.Current));
            });
        }

        [Test]
        public void Frame_NotNeeded_IsNotPredicted()
        {
            var cell = new CellSession();
            cell.Sampling = t => cell.Send("world", "elsewhere", t, Along(t));
            cell.Run(1);
            Assert.That(cell.Session.Frames.Tree.Count, Is.Zero);

            cell.Session.Frames.Need("elsewhere");
            cell.Sampling = null;
            cell.Run(0.02);

            Assert.That(cell.Session.Frames.Find("elsewhere").World.X, Is.EqualTo(20.9).Within(0.06), "the newest pose was kept");
        }

        [Test]
        public void Need_FrameWithParents_TracksTheParentsToo()
        {
            var cell = new CellSession();
            cell.Sampling = t =>
            {
                cell.Send("world", "table", t, Along(1));
                cell.Send("table", "plate", t, Along(0.1));
            };
            cell.Send("plate", "screw", 19, Along(0.01), isStationary: true);
            cell.Run(0.2);

            cell.Session.Frames.Need("screw");
            cell.Run(0.3);

            Assert.That(cell.Session.Frames.Find("screw").World.X, Is.EqualTo(1.11).Within(1e-9));
            Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("screw")), Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void Frame_ParentIsALink_MovesExactlyWithTheDisplayedRobot()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("part");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Math.Sin(2 * t), Math.Cos(3 * t));
                cell.Send("tool_centre_point", "part", t, Along(0.03));
            };
            cell.Run(1);

            cell.Run(2, _ => AssertInGripper(cell));
        }

        // ROS publishes the links of a robot on /tf too.
        [TestCase(true)]
        [TestCase(false)]
        public void Frame_LinksOnTf_MovesExactlyWithTheDisplayedRobot(bool isLinkShown)
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("part");
            if (isLinkShown) cell.Session.Frames.Need("tool_centre_point");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Math.Sin(2 * t), Math.Cos(3 * t));
                cell.Send("world", "lower", t, Along(7));
                cell.Send("lower", "tool_centre_point", t, Along(9));
                cell.Send("tool_centre_point", "part", t, Along(0.03));
            };
            cell.Run(1);

            cell.Run(1, _ => AssertInGripper(cell));

            var tree = cell.Session.Frames.Tree;
            Assert.That(tree.IsCarried(tree.IndexOf("part")));
            Assert.That(tree.Count, Is.EqualTo(isLinkShown ? 2 : 1), "links are predicted only if they are shown");
        }

        const string TwoBranches = @"<robot name='two branches'>
            <link name='base'/><link name='arm'/><link name='tool_centre_point'/><link name='table'/>
            <joint name='shoulder' type='continuous'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/></joint>
            <joint name='tool' type='fixed'><parent link='arm'/><child link='tool_centre_point'/><origin xyz='0.5 0 0'/></joint>
            <joint name='turn' type='continuous'><parent link='base'/><child link='table'/><axis xyz='0 0 1'/></joint>
        </robot>";

        [Test]
        public void StateOf_FrameOnALinkWhoseJointHasNoSamples_IsCurrentOnlyWithItsSamples()
        {
            var cell = new CellSession();
            cell.Session.Robots.Add("arm2", UrdfReader.Read(TwoBranches, "test"));
            foreach (var name in new[] { "on_table", "in_hand" }) cell.Session.Frames.Need(name);
            cell.Send("arm2/table", "on_table", 0, Along(0.1), isStationary: true);
            cell.Send("arm2/tool_centre_point", "in_hand", 0, Along(0.1), isStationary: true);
            PoseState StateOf(string name) => cell.Session.Frames.StateOf(cell.Session.Frames.Find(name));
            void Send(double t, params string[] joints) => cell.Session.Listener.Received(
                new JointStateMessage(ControlTime.FromSeconds(t), joints, new double[joints.Length]), HeadsetTime.FromSeconds(t + CellSession.Latency), "arm2");

            cell.Sampling = t => Send(t, "shoulder");
            cell.Run(1);
            Assert.That((StateOf("in_hand"), StateOf("on_table")), Is.EqualTo((PoseState.Current, PoseState.Held)), "never received");

            cell.Sampling = t => Send(t, "shoulder", "turn");
            cell.Run(1);
            Assert.That((StateOf("in_hand"), StateOf("on_table")), Is.EqualTo((PoseState.Current, PoseState.Current)));

            cell.Sampling = t => Send(t, "shoulder");
            cell.Run(1);
            Assert.That((StateOf("in_hand"), StateOf("on_table")), Is.EqualTo((PoseState.Current, PoseState.Held)), "no longer received");
        }

        [Test]
        public void Frame_ClockUnknown_StaysInTheDisplayedGripper()
        {
            var cell = new CellSession(isClockKnown: false);
            cell.Session.Frames.Need("part");
            cell.Send("tool_centre_point", "part", 0, Along(0.03), isStationary: true);
            cell.Sampling = t => cell.SendJoints(t, Math.Sin(2 * t), 0);
            cell.Run(0.5);

            cell.Run(1, _ =>
            {
                AssertInGripper(cell);
                Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("part")), Is.EqualTo(PoseState.Unsynchronised));
            });
        }

        static void AssertInGripper(CellSession cell)
        {
            var robot = cell.Session.Robots[0];
            var tool = robot.Poses[robot.Robot.IndexOfLink("tool_centre_point")];
            Assert.That(Distance(cell.Session.Frames.Find("part").World, tool * Along(0.03)), Is.LessThan(1e-9));
        }

        [Test]
        public void Frame_NoLongerSent_IsHeld()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            cell.Sampling = t => cell.Send("world", "box", t, Along(t));
            cell.Run(0.5);

            cell.Sampling = null;
            cell.Run(1);

            Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("box")), Is.EqualTo(PoseState.Held));
        }

        [Test]
        public void StateOf_NeverReceivedOrWithoutParent_IsIncomplete()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("lost");
            cell.Session.Frames.Need("never");
            cell.Sampling = t => cell.Send("unknown parent", "lost", t, Along(t));
            cell.Run(0.5);

            Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("lost")), Is.EqualTo(PoseState.Incomplete));
            Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("never")), Is.EqualTo(PoseState.Incomplete));
        }

        [Test]
        public void StateOf_StationaryInTheWorld_IsCurrentWithoutAClock()
        {
            var cell = new CellSession(isClockKnown: false);
            cell.Session.Frames.Need("fixture");
            cell.Send("world", "fixture", 0, Along(0.5), isStationary: true);
            cell.Run(0.1);

            Assert.That(cell.Session.Frames.Find("fixture").World.X, Is.EqualTo(0.5));
            Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("fixture")), Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void Frame_SentBeforeTheClockIsKnown_WaitsForTheClock()
        {
            var cell = new CellSession(isClockKnown: false);
            cell.Session.Frames.Need("box");
            cell.Sampling = t => cell.Send("world", "box", t, Along(t));
            cell.Run(0.3);
            Assert.That(cell.Session.Frames.Find("box"), Is.Null);

            cell.Synchronise();
            cell.Run(0.3, null);

            Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("box")), Is.EqualTo(PoseState.Current));
        }

        // Tracked poses wait for a known control time, and stationary poses do not.
        [TestCase(true)]
        [TestCase(false)]
        public void Frame_StationaryPoseAfterATrackedPose_StaysStationary(bool isClockKnown)
        {
            var cell = new CellSession(isClockKnown);
            cell.Session.Frames.Need("box");
            cell.Send("world", "box", 19.5, Along(7));
            if (isClockKnown) cell.Run(0.2);

            cell.Send("world", "box", 19.6, Along(8));
            cell.Send("world", "box", 19.7, Along(0.5), isStationary: true);
            cell.Run(0.2);
            if (!isClockKnown) cell.Synchronise();
            cell.Run(1);

            Assert.That((cell.Session.Frames.Find("box").IsStationary, cell.Session.Frames.Find("box").World.X), Is.EqualTo((true, 0.5)));
            cell.Sampling = t => cell.Send("world", "box", t, Along(9));
            cell.Run(1);
            Assert.That(cell.Session.Frames.Find("box").World.X, Is.EqualTo(9).Within(1e-9), "a later tracked pose is used");
        }

        [Test]
        public void Frame_StampInTheFuture_IsDroppedAndCounted()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            cell.Sampling = t => cell.Send("world", "box", t, Along(t));
            cell.Run(0.5);

            cell.Session.Listener.FramesReceived(
                new TransformsMessage(Along(99).ToTransform(ControlTime.FromSeconds(cell.Now + 5), "world", "box")), false,
                HeadsetTime.FromSeconds(cell.Now));
            cell.Run(0.3);

            Assert.That(cell.Session.Drops[DropReason.StampInFuture], Is.EqualTo(1));
            Assert.That(cell.Session.Frames.StateOf(cell.Session.Frames.Find("box")), Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void Frames_MoreThanAllowed_AreDroppedAndCounted()
        {
            var cell = new CellSession();
            for (var i = 0; i < ProtocolLimits.Frames + 3; i++) cell.Send("world", "f" + i, 0, Along(i), isStationary: true);

            cell.Run(0.1);

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames] + cell.Session.Drops[DropReason.SlowReader], Is.EqualTo(3));
        }

        [Test]
        public void Frames_MoreThanAllowed_ReplaceOnlyFramesThatAreSilentAndNotShown()
        {
            var cell = new CellSession();
            void Receive(params string[] frames)
            {
                var stamp = ControlTime.FromSeconds(cell.Now - 0.1);
                cell.Session.Listener.FramesReceived(
                    new TransformsMessage(frames.Select(frame => Along(1).ToTransform(stamp, "world", frame)).ToArray()), false, HeadsetTime.FromSeconds(cell.Now));
            }

            Receive(Enumerable.Range(0, ProtocolLimits.Frames).Select(i => "old" + i).ToArray());
            cell.Run(9);
            Receive("early");
            cell.Run(2);
            Receive("late");
            cell.Run(0.1);

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames], Is.EqualTo(1));
            foreach (var frame in new[] { "early", "late" }) cell.Session.Frames.Need(frame);
            Assert.That(cell.Session.Frames.Find("early"), Is.Null);
            Assert.That(cell.Session.Frames.Find("late"), Is.Not.Null);
        }
    }
}
