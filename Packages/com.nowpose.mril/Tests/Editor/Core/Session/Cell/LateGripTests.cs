using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Compares a headset that connects before, during or after the closing of a gripper with one that was connected all the time.</summary>
    public class LateGripTests
    {
        /// <summary>Maximum time from the closing until its message has arrived and the correction of the displayed pose has faded out, s.</summary>
        const double Correction = 0.25;

        const double BeforeConnection = 19;

        readonly Dictionary<(string, bool, bool), Dictionary<int, (PoseState State, RigidTransform Box)>> _early =
            new Dictionary<(string, bool, bool), Dictionary<int, (PoseState State, RigidTransform Box)>>();

        // The latched value of the signal and the latched stationary pose arrive when the headset connects, but no earlier samples.
        [Category("Study")]
        [Test]
        public void Connect_AtAnyTimeOfAGrip_ObjectIsAtTheSamePlaceOrNotCurrent(
            [Values(-0.3, -0.05, -0.02, 0, 0.02, 0.05, 0.3, 1.9, 2.03)] double connect, [Values(false, true)] bool isStationary,
            [Values(false, true)] bool restsBefore, [Values("adaptive", "hold")] string predictor)
        {
            var early = EarlyShown(predictor, isStationary, restsBefore);

            var late = Shown(predictor, isStationary, restsBefore, Close + connect, out _);

            foreach (var frame in late.Keys.Where(frame => Math.Abs(LightOf(frame) - Close - Correction / 2) > Correction / 2))
                if (late[frame].State == PoseState.Current && early[frame].State == PoseState.Current
                    && !(Distance(late[frame].Box, early[frame].Box) < 0.001)) Assert.Fail(LightOf(frame) + " s: the box is at another place");
        }

        [TestCase(-0.3, PoseState.Current, null)]
        [TestCase(0.3, PoseState.Held, FrameMessages.ArmWithoutData)]
        [TestCase(1.5, PoseState.Held, FrameMessages.ArmWithoutData)]
        public void Connect_BeforeOrDuringAGrip_ObjectIsCurrentOnlyIfItsPlaceInTheGripperIsKnown(double connect, PoseState state, string fault)
        {
            var late = Shown("adaptive", false, false, Close + connect, out var faults);

            var frames = late.Keys.Where(frame => LightOf(frame) > Close + Correction + Math.Max(0, connect) && LightOf(frame) < Open).ToList();
            Assert.That(frames, Has.Count.GreaterThan(10));
            Assert.That(frames.Select(frame => late[frame].State), Is.All.EqualTo(state));
            Assert.That(frames.Select(frame => faults[frame]), Is.All.EqualTo(fault));
        }

        // The same for all times of the connection.
        Dictionary<int, (PoseState State, RigidTransform Box)> EarlyShown(string predictor, bool isStationary, bool restsBefore)
        {
            var key = (predictor, isStationary, restsBefore);
            if (!_early.TryGetValue(key, out var shown))
                _early[key] = shown = Shown(predictor, isStationary, restsBefore, BeforeConnection, out _);
            return shown;
        }

        static double LightOf(int frame) => 20 + frame / 60.0 + CellSession.Visu;

        /// <summary>Returns the displayed state and pose of a box in each frame of a headset, until after the gripper has opened.</summary>
        /// <param name="restsBefore">Whether the arm starts to move only after the closing.</param>
        /// <param name="connect">Time of the connection, s.</param>
        /// <param name="faults">Receives the gripper's fault in each frame.</param>
        static Dictionary<int, (PoseState State, RigidTransform Box)> Shown(
            string predictor, bool isStationary, bool restsBefore, double connect, out Dictionary<int, string> faults)
        {
            var (shown, faultOf, frame) = (new Dictionary<int, (PoseState, RigidTransform)>(), new Dictionary<int, string>(), 0);
            var cell = new CellSession(isClockKnown: false, predictor);
            var grip = NewGrip(cell, "box");
            cell.Sampling = t =>
            {
                if (t + CellSession.Latency < connect) return;
                cell.SendJoints(t, restsBefore ? Math.Max(0, Shoulder(t - 0.5)) : Shoulder(t), 0);
                if (!isStationary) cell.Send("world", "box", t, At(1.05, 0.02));
            };
            Run(connect);
            cell.Synchronise();
            cell.Reconnect();
            if (isStationary) cell.SendLate("world", "box", 0, cell.Now - CellSession.Latency, At(1.05, 0.02), isStationary: true);
            var changes = new (double Stamp, double Value)[] { (BeforeConnection, 0), (Close, 1), (Open, 0) };
            foreach (var change in changes.Skip(changes.Count(each => each.Stamp + CellSession.Latency <= cell.Now) - 1))
            {
                Run(change.Stamp + CellSession.Latency);
                SendGripNow(cell, change.Stamp, change.Value);
            }
            Run(Open + 2);
            faults = faultOf;
            return shown;

            void Run(double until)
            {
                if (until > cell.Now) Until(cell, until, Add);
            }

            void Add(double light)
            {
                if (Find(cell, "box") is { } box) shown[frame] = (StateOf(cell), box.World);
                faultOf[frame++] = grip.Fault;
            }
        }
    }
}
