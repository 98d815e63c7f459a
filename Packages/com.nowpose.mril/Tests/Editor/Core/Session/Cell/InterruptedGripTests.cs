using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>
    /// Tests grips by reach after an interruption of the gripper's signal: a lost connection, or an end of the signal's source. The sources of the
    /// objects repeat their poses. If the first value after the interruption has another stamp, the signal may have changed unnoticed.
    /// </summary>
    public class InterruptedGripTests
    {
        const double End = 22.5, Start = 26;

        [Test]
        public void Interruption_ClosedBeforeAndAfterwards_HeldObjectIsUnknownUnlessTheStampIsTheFormerOne(
            [Values(15, Close, Start - 1)] double stamp, [Values(false, true)] bool isOfConnection)
        {
            var (cell, grip) = NewGripper();
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, End);
            Assert.That((grip.Held, StateOf(cell), StateOf(cell, "other")), Is.EqualTo(("box", PoseState.Current, PoseState.Current)));

            Interrupt(cell, isOfConnection, stamp, 1);

            var isUnknown = stamp != Close;
            var expected = isUnknown ? PoseState.Held : PoseState.Current;
            Until(cell, Start + 1, t => Assert.That((grip.Fault, StateOf(cell), StateOf(cell, "other")),
                Is.EqualTo((isUnknown ? FrameMessages.SignalInterrupted : null, expected, expected)), $"{t} s"));

            cell.Send("grip", Start + 1, 0);
            Until(cell, Start + 2);
            Assert.That((grip.Held, grip.Fault, StateOf(cell), StateOf(cell, "other")), Is.EqualTo(((string)null, (string)null, expected, expected)));
        }

        [Test]
        public void Interruption_OpenBeforeAndAfterwards_ObjectsAreHeldUnlessTheStampIsTheFormerOne(
            [Values(15, 19, Start - 1)] double stamp, [Values(false, true)] bool isOfConnection)
        {
            var (cell, grip) = NewGripper();
            Until(cell, End);

            Interrupt(cell, isOfConnection, stamp, 0);

            var expected = stamp != 19 ? PoseState.Held : PoseState.Current;
            Until(cell, Start + 1, t =>
                Assert.That((grip.Fault, StateOf(cell), StateOf(cell, "other")), Is.EqualTo(((string)null, expected, expected)), $"{t} s"));
        }

        // Few samples or none have arrived since the interruption when the value arrives, so the noise of the tracker is not known yet.
        [Test]
        public void Interruption_OpenAfterwardsAndSourceHasNoise_ObjectIsHeldUntilTheSourceReportsAnotherPose(
            [Values(0, 0.1, 0.4)] double signalDelay, [Values(false, true)] bool isOfConnection)
        {
            const double move = Start + 3;
            var random = new Random(1);
            double Noise() => 0.001 * random.NextNormal();
            var (cell, grip) = NewGripper();
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, RigidTransform.FromXyzRpy((t < move ? 1 : 1.1) + Noise(), Noise(), Noise(), 0, 0, 0));
            };
            Until(cell, End);

            Interrupt(cell, isOfConnection, Start - 1, 0, signalDelay);

            Until(cell, move, t => Assert.That((grip.Fault, StateOf(cell)), Is.EqualTo(((string)null, PoseState.Held)), $"{t} s"));
            Until(cell, move + 1);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void Interruption_ControlClockStepsInTheMeantime_ObjectsAreHeld()
        {
            const double step = 7;
            var (cell, _) = NewGripper();
            Until(cell, End);
            cell.Reconnect();
            cell.Sampling = null;
            cell.ClockStep = step;
            Until(cell, Start + 4);
            Assert.That(cell.Session.Clock.Steps, Is.EqualTo(1));

            cell.Sampling = t => SendAll(cell, t + step, 1);
            SendGripNow(cell, cell.Now + step - 0.1, 0);
            Until(cell, Start + 5);

            Assert.That((StateOf(cell), StateOf(cell, "other")), Is.EqualTo((PoseState.Held, PoseState.Held)));
        }

        // A value with a stamp in the future is not used.
        [Test]
        public void Interruption_FirstValueIsInTheFuture_ObjectsAreHeldAfterTheNextValue([Values(false, true)] bool isOfConnection)
        {
            var (cell, _) = NewGripper();
            Until(cell, End);

            Interrupt(cell, isOfConnection, Start + 60, 0);
            SendGripNow(cell, cell.Now - 0.1, 0);
            Until(cell, Start + 1);

            Assert.That((StateOf(cell), StateOf(cell, "other")), Is.EqualTo((PoseState.Held, PoseState.Held)));
        }

        [Test]
        public void Interruption_OpenAfterwards_ObjectFollowsItsSourceAndIsHeldUntilTheSourceReportsAnotherPose([Values(false, true)] bool isOfConnection)
        {
            var (cell, grip) = NewGripper(t => t < Start + 1 ? 1 : 1.1);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, End);

            Interrupt(cell, isOfConnection, Start - 1, 0);

            Until(cell, Start + 1, t =>
                Assert.That((grip.Held, grip.Fault, StateOf(cell)), Is.EqualTo(((string)null, (string)null, PoseState.Held)), $"{t} s"));
            Assert.That(Distance(Find(cell, "box").World, At(1, 0)), Is.LessThan(1e-9));
            Assert.That(Find(cell, "box").GripFault, Is.EqualTo(FrameMessages.ReleasedUnnoticed));

            Until(cell, Start + 2);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        // The conveyor brings the box during the interruption. The gripper then carries it away unnoticed, and opens.
        [Test]
        public void Interruption_SourceMovesTheObjectBeforeAnUnnoticedGrip_ObjectIsHeldAfterTheOpening([Values] bool isClosedAfterwards)
        {
            var (cell, _) = NewGripper(t => Math.Min(1, 0.5 + 0.5 * Math.Max(0, t - End - 0.5)));
            Until(cell, End);

            Interrupt(cell, isOfConnection: false, Start - 1, isClosedAfterwards ? 1 : 0);
            if (isClosedAfterwards) cell.Send("grip", Start + 0.6, 0);

            Until(cell, Start + 2, t => Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held), $"{t} s"));
        }

        // The poses from before the stop arrive after the change of the signal is visible.
        [TestCase(0)]
        [TestCase(0.04)]
        public void Interruption_ObjectStopsJustBeforeTheGrip_ObjectIsHeldAfterTheOpening(double rest)
        {
            var (cell, grip) = NewGripper(t => Math.Min(1, 1 + 0.2 * (t - Close + rest)));
            Until(cell, Close - 0.03);
            SendGripNow(cell, Close, 1);
            Until(cell, End);
            Assert.That(grip.Held, Is.EqualTo("box"));

            Interrupt(cell, isOfConnection: false, Start - 1, 0);

            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));
        }

        // The stamp may be that of a repeated value, so it does not show where the gripper closed.
        [Test]
        public void Interruption_ClosedAfterwards_HeldObjectIsUnknown([Values(false, true)] bool isOfConnection)
        {
            var (cell, grip) = NewGripper();
            Until(cell, End);

            Interrupt(cell, isOfConnection, Start - 1, 1);

            Until(cell, Start + 1, t => Assert.That((grip.Held, grip.Fault, StateOf(cell)),
                Is.EqualTo(((string)null, FrameMessages.SignalInterrupted, PoseState.Held)), $"{t} s"));
        }

        // The frame loop pauses, and the full queue keeps only the newest value of the signal.
        [Test]
        public void Interruption_GripperOpensAndClosesInAFullQueue_HeldObjectIsUnknown()
        {
            var (cell, grip) = NewGripper();
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, End);

            cell.Send("grip", End + 0.1, 0);
            cell.Send("grip", End + 0.3, 1);
            FillQueue(cell);
            Until(cell, End + 1);

            Assert.That((grip.Fault, StateOf(cell)), Is.EqualTo((FrameMessages.SignalInterrupted, PoseState.Held)));
        }

        // When the repeated value arrives, the arm has left the box.
        [Test]
        public void Interruption_ClosingIsRepeatedInAFullQueue_ObjectIsGrippedAtTheTimeOfTheClosing()
        {
            var (cell, grip) = NewGripper();
            Until(cell, Close);

            cell.Send("grip", Close, 1);
            cell.Send("grip", Close + 0.4, 1);
            cell.Send("grip", Close + 0.3, 1); // arrives after a newer message
            FillQueue(cell);
            Until(cell, Close + 1, t => Assert.That(grip.Fault, Is.Null, $"{t} s"));

            Assert.That((grip.Held, StateOf(cell)), Is.EqualTo(("box", PoseState.Current)));
        }

        static void FillQueue(CellSession cell)
        {
            for (var k = 0; k < 1100; k++) cell.Send("speed", cell.Now - 1 + 0.001 * k, k);
        }

        static (CellSession Cell, ReachGrip Grip) NewGripper(Func<double, double> x = null)
        {
            var (cell, grip) = NewCell("box", "other");
            cell.Sampling = t => SendAll(cell, t, x?.Invoke(t) ?? 1);
            cell.Send("grip", 19, 0);
            return (cell, grip);
        }

        static void SendAll(CellSession cell, double stamp, double x)
        {
            cell.SendJoints(stamp, Shoulder(stamp), 0);
            cell.Send("world", "box", stamp, At(x, 0));
            cell.Send("world", "other", stamp, At(-1, 0));
        }

        // For example, an adapter has lost its PLC or broker. It sends the value again with the time of its change.
        [TestCase(JointDataState.Stale)]
        [TestCase(JointDataState.Fault)]
        [TestCase(JointDataState.Refused)]
        [TestCase(JointDataState.Missing)]
        public void Interruption_SourceCannotReadTheSignal_HeldObjectIsUnknown(JointDataState state)
        {
            var (cell, grip) = NewGripper();
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, End);
            Assert.That(grip.Held, Is.EqualTo("box"));

            Interrupt(cell, isOfConnection: false, Start - 1, 1, state: state);

            Until(cell, Start + 1, t =>
                Assert.That((grip.Fault, StateOf(cell)), Is.EqualTo((FrameMessages.SignalInterrupted, PoseState.Held)), $"{t} s"));
        }

        // Nothing arrives while the connection is interrupted.
        static void Interrupt(
            CellSession cell, bool isOfConnection, double stamp, double value, double signalDelay = 0, JointDataState state = JointDataState.Stale)
        {
            var sampling = cell.Sampling;
            if (isOfConnection) cell.Sampling = null;
            else Report(cell, new JointReport("grip", state, ControlTime.FromSeconds(End), "its source has ended"));
            Until(cell, Start);
            if (isOfConnection) cell.Reconnect();
            else Report(cell);
            cell.Sampling = sampling;
            Until(cell, Start + signalDelay);
            SendGripNow(cell, stamp, value);
            Until(cell, Start + 0.5);
        }

        static void Report(CellSession cell, params JointReport[] reports) =>
            cell.Session.Listener.SignalStatusReceived(new JointStatusMessage(reports), HeadsetTime.FromSeconds(cell.Now));
    }
}
