using System.Collections.Generic;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests the states of displayed frames whose data, clock or render time are not as they should be.</summary>
    public class SessionFrameStatesTests
    {
        // The pose of a chain of stationary frames needs no display time. A frame on a moving frame or on a link needs it.
        [TestCase(true)]
        [TestCase(false)]
        public void StateOf_StationaryOnAStationaryFrame_IsCurrentAtAnyDisplayTime(bool isClockKnown)
        {
            var cell = new CellSession(isClockKnown, range: SmallRange);
            foreach (var name in new[] { "screw", "on_turntable", "on_link", "lost" }) cell.Session.Frames.Need(name);
            cell.Send("world", "table", 0, Along(0.5), isStationary: true);
            cell.Send("table", "plate", 0, Along(0.1), isStationary: true);
            cell.Send("plate", "screw", 0, Along(0.01), isStationary: true);
            cell.Send("turntable", "on_turntable", 0, Along(0.1), isStationary: true);
            cell.Send("tool_centre_point", "on_link", 0, Along(0.1), isStationary: true);
            cell.Send("unknown parent", "lost", 0, Along(0.1), isStationary: true);
            cell.Sampling = t => cell.Send("world", "turntable", t, Along(0));
            for (var i = 0; i < 60; i++) cell.Session.Rendered(Lengths.Ms(20), RenderTimeSourceKind.DisplayGpuTime);

            cell.Run(1);

            Assert.That(StateOf(cell, "screw"), Is.EqualTo(PoseState.Current));
            Assert.That(StateOf(cell, "on_link"), Is.Not.EqualTo(PoseState.Current));
            Assert.That(StateOf(cell, "on_turntable"), Is.EqualTo(isClockKnown ? PoseState.OutsideRange : PoseState.Incomplete));
            Assert.That(StateOf(cell, "lost"), Is.EqualTo(PoseState.Incomplete));
        }

        // The range affects all poses; a frame whose own data, or whose robot's data, have stopped has a more severe state.
        [TestCase(OutsideRangeResponse.Fade)]
        [TestCase(OutsideRangeResponse.Hold)]
        public void StateOf_OutsideRange_IsHeldOnlyIfItsDataHaveStopped(OutsideRangeResponse response)
        {
            var cell = new CellSession(range: SmallRange, outsideRange: response);
            foreach (var name in new[] { "box", "stopped", "on_stopped", "in_hand" }) cell.Session.Frames.Need(name);
            var isRobotSent = true;
            cell.Sampling = t =>
            {
                if (isRobotSent) cell.SendJoints(t, 0, 0);
                cell.Send("world", "box", t, Along(t));
                if (t < 20.5) cell.Send("world", "stopped", t, Along(t));
                cell.Send("stopped", "on_stopped", t, Along(0.1));
                cell.Send("tool_centre_point", "in_hand", t, Along(0.1));
            };
            for (var i = 0; i < 60; i++) cell.Session.Rendered(Lengths.Ms(20), RenderTimeSourceKind.DisplayGpuTime);

            cell.Run(2);
            Assert.That((StateOf(cell, "box"), StateOf(cell, "in_hand")), Is.EqualTo((PoseState.OutsideRange, PoseState.OutsideRange)));
            Assert.That((StateOf(cell, "stopped"), StateOf(cell, "on_stopped")), Is.EqualTo((PoseState.Held, PoseState.Held)));

            isRobotSent = false;
            cell.Run(1);
            Assert.That((StateOf(cell, "box"), StateOf(cell, "in_hand")), Is.EqualTo((PoseState.OutsideRange, PoseState.Held)));
        }

        // Such a link is, for example, a table in the robot's description.
        [Test]
        public void StateOf_ObjectOnALinkThatNoJointMoves_IsCurrentWithoutDataOfTheJoints([Values] bool hasSamples, [Values] bool isClockKnown)
        {
            var cell = new CellSession(isClockKnown);
            foreach (var name in new[] { "plate", "in_hand" }) cell.Session.Frames.Need(name);
            cell.Send("base", "plate", 0, Along(0.1), isStationary: true);
            cell.Send("tool_centre_point", "in_hand", 0, Along(0.1), isStationary: true);
            cell.Sampling = t =>
            {
                if (hasSamples && t < 20.5) cell.SendJoints(t, 0, 0);
            };

            cell.Run(2);

            Assert.That(StateOf(cell, "in_hand"), Is.Not.EqualTo(PoseState.Current));
            Assert.That(StateOf(cell, "plate"), Is.EqualTo(PoseState.Current));
            Assert.That(cell.Session.Frames.Faults(null).Select(fault => fault.Name), Has.None.EqualTo("plate"));
        }

        // The clock of the source is behind, or a recording is played with its former stamps.
        [TestCase(3)]
        [TestCase(15)]
        public void Faults_PosesArriveWithOldStamps_HaveTheReasonUntilThePosesStop(double age)
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            cell.Sampling = t => cell.SendLate("world", "box", t - age, t, Along(t));
            string Reason() => cell.Session.Frames.Faults(null).Single().Reason;

            cell.Run(2, _ => Assert.That(StateOf(cell, "box"), Is.Not.EqualTo(PoseState.Current)));
            Assert.That(Reason(), Is.EqualTo(FrameMessages.PosesTooOld));

            cell.Sampling = null;
            cell.Run(1.5);
            Assert.That(Reason(), Is.EqualTo(FrameMessages.PosesStopped));
        }

        // Predicted up to 0.3 s: until shortly before the next pose arrives.
        [Test]
        public void Faults_PosesAreTooOldBetweenArrivals_NameOldStamps()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            var next = 20.0;
            cell.Sampling = t =>
            {
                if (t < next) return;
                cell.SendLate("world", "box", t - 0.2, t, Along(t));
                next += 0.2;
            };
            var reasons = new HashSet<string>();

            cell.Run(2);
            cell.Run(3, _ => reasons.UnionWith(cell.Session.Frames.Faults(null).Select(fault => fault.Reason)));

            Assert.That(reasons, Is.EquivalentTo(new[] { FrameMessages.PosesTooOld }));
        }

        [TestCase(0.4)]
        [TestCase(0.6)]
        [TestCase(0.9)]
        public void Faults_CurrentPosesArriveRarely_NameTheRarePoses(double interval)
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            var next = 20.0;
            cell.Sampling = t =>
            {
                if (t < next) return;
                cell.Send("world", "box", t, Along(t));
                next += interval;
            };

            cell.Run(2);
            cell.Run(5, _ => Assert.That(
                cell.Session.Frames.Faults(null).Select(fault => fault.Reason), Is.Empty.Or.EqualTo(new[] { FrameMessages.PosesTooRare })));

            Assert.That(cell.Session.Frames.Find("box").Newest, Is.GreaterThan(ControlTime.FromSeconds(26)));
        }

        [Test]
        public void Faults_CurrentPosesStop_NeverNameOldStamps()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("box");
            cell.Sampling = t => cell.Send("world", "box", t, Along(t));
            cell.Run(1);
            cell.Sampling = null;

            cell.Run(3, _ => Assert.That(cell.Session.Frames.Faults(null).Select(fault => fault.Reason), Is.All.EqualTo(FrameMessages.PosesStopped)));

            Assert.That(StateOf(cell, "box"), Is.EqualTo(PoseState.Held));
        }

        [Test]
        public void HeldSince_FrameOrItsParentStopped_IsTheStampOfTheNewestPose()
        {
            var cell = new CellSession();
            foreach (var name in new[] { "table", "on_table", "in_hand" }) cell.Session.Frames.Need(name);
            var newest = 0.0;
            cell.Sampling = t =>
            {
                if (t < 20.5) cell.Send("world", "table", newest = t, Along(t));
                cell.Send("table", "on_table", t, Along(0.1));
                cell.Send("tool_centre_point", "in_hand", t, Along(0.1));
            };
            ControlTime? SinceOf(string frame) => cell.Session.Frames.HeldSince(cell.Session.Frames.Find(frame));
            cell.Run(0.3);
            Assert.That((SinceOf("table"), SinceOf("on_table"), SinceOf("none")), Is.EqualTo(((ControlTime?)null, (ControlTime?)null, (ControlTime?)null)));

            cell.Run(2);

            Assert.That(SinceOf("table"), Is.EqualTo(ControlTime.FromSeconds(newest)));
            Assert.That(SinceOf("on_table"), Is.EqualTo(ControlTime.FromSeconds(newest)), "the frame above it has stopped");
            Assert.That(SinceOf("in_hand"), Is.Null, "its robot has never had data");
        }

        [Test]
        public void HeldSince_FrameAboveUnknownOrStationaryPoseOutdated_IsTheTimeAtWhichThisStateBegan()
        {
            var cell = new CellSession();
            foreach (var name in new[] { "table", "on_table", "lost" }) cell.Session.Frames.Need(name);
            ControlTime? SinceOf(string frame) => cell.Session.Frames.HeldSince(cell.Session.Frames.Find(frame));
            cell.Reconnect();
            cell.Send("world", "table", 20, Along(0), isStationary: true);
            cell.Send("table", "on_table", 20, Along(0), isStationary: true);
            cell.Run(1);
            Assert.That((SinceOf("table"), SinceOf("on_table")), Is.EqualTo(((ControlTime?)null, (ControlTime?)null)));

            cell.Send("unknown parent", "lost", cell.Now, Along(0.1), isStationary: true);
            cell.Reconnect();
            double outdated = double.NaN, lost = double.NaN;
            cell.Run(5, at =>
            {
                if (double.IsNaN(outdated) && StateOf(cell, "table") == PoseState.Held) outdated = at;
                if (double.IsNaN(lost) && cell.Session.Frames.Find("lost")?.State == FrameState.Orphan) lost = at;
            });

            Assert.That(SinceOf("table").Value.SinceEpoch.TotalSeconds, Is.EqualTo(outdated).Within(1e-3));
            Assert.That(SinceOf("on_table"), Is.EqualTo(SinceOf("table")));
            Assert.That(SinceOf("lost").Value.SinceEpoch.TotalSeconds, Is.EqualTo(lost).Within(1e-3));
        }

        [Test]
        public void HeldSince_RobotStopped_IsTheStampOfItsNewestSample()
        {
            var cell = new CellSession();
            foreach (var name in new[] { "in_hand", "screw" }) cell.Session.Frames.Need(name);
            var newest = 0.0;
            cell.Sampling = t =>
            {
                if (t < 20.5) cell.SendJoints(newest = t, 0, 0);
                cell.Send("tool_centre_point", "in_hand", t, Along(0.1));
                cell.Send("in_hand", "screw", t, Along(0.1));
            };

            cell.Run(2);

            var (frames, screw) = (cell.Session.Frames, cell.Session.Frames.Find("screw"));
            Assert.That((screw.State, frames.HeldSince(screw)), Is.EqualTo((FrameState.ParentNotCurrent, (ControlTime?)ControlTime.FromSeconds(newest))));
            Assert.That(frames.Tree.ReasonAbove(screw, out _, out var robot), Is.EqualTo("tool_centre_point"));
            Assert.That(robot, Is.SameAs(cell.Session.Robots[0]));
        }

        [Test]
        public void HeldSince_RobotStoppedAfterItsFinger_IsTheStampOfTheNewestSampleOfTheArm()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("in_hand");
            var newest = 0.0;
            cell.Sampling = t =>
            {
                if (t < 20.5) cell.SendJoints(newest = t, 0, 0);
                cell.Send("tool_centre_point", "in_hand", t, Along(0.1));
            };
            cell.Run(0.5);

            var finger = new JointReport("grip", JointDataState.Stale, ControlTime.FromSeconds(5), "");
            cell.Session.Listener.StatusReceived(new JointStatusMessage(new[] { finger }), HeadsetTime.FromSeconds(cell.Now));
            cell.Run(0.1);
            Assert.That(StateOf(cell, "in_hand"), Is.EqualTo(PoseState.Current), "the finger alone does not hold the arm");
            cell.Run(1.5);

            var held = cell.Session.Frames.Find("in_hand");
            Assert.That(held.State, Is.EqualTo(FrameState.ParentNotCurrent));
            Assert.That(cell.Session.Frames.HeldSince(held), Is.EqualTo(ControlTime.FromSeconds(newest)));
        }

        [Test]
        public void ReasonAbove_FrameAboveStoppedOrIsUnknown_IsThatFrame()
        {
            var cell = new CellSession();
            foreach (var name in new[] { "screw", "lost" }) cell.Session.Frames.Need(name);
            cell.Send("plate", "screw", 20, Along(0.1), isStationary: true);
            cell.Send("table", "plate", 20, Along(0.1), isStationary: true);
            cell.Send("conveyor", "lost", 20, Along(0.1), isStationary: true);
            cell.Send("hall", "conveyor", 20, Along(0.1), isStationary: true);
            cell.Sampling = t =>
            {
                if (t < 20.5) cell.Send("world", "table", t, Along(t));
            };

            cell.Run(2);

            string ReasonOf(string name) => cell.Session.Frames.Tree.ReasonAbove(cell.Session.Frames.Find(name), out _, out _);
            Assert.That((ReasonOf("screw"), ReasonOf("lost")), Is.EqualTo(("table", "hall")));
        }

        static ConstantLatencyRange SmallRange => new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime);

        static PoseState StateOf(CellSession cell, string frame) => cell.Session.Frames.StateOf(cell.Session.Frames.Find(frame));

        static RigidTransform Along(double x) => RigidTransform.FromXyzRpy(x, 0, 0, 0, 0, 0);
    }
}
