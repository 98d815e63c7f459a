using System;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>
    /// Tests grips by reach after a restart of a source or of the control clock. The source of the object does not report the grip.
    /// </summary>
    public class GripRestartTests
    {
        /// <summary>Time by which the stamps of a restarted source go back, s.</summary>
        const double Back = 10;

        static readonly RigidTransform Place = At(1.05, 0.02);

        [Test]
        public void Source_Restarts_HeldObjectReturnsToTheReportedPose([Values(0, 1)] int value)
        {
            var (cell, grip) = NewCell("box");
            var back = 0.0;
            cell.Sampling = t =>
            {
                SendAll(cell, t - back, t);
                if (back > 0) cell.Send("grip", t - back, value);
            };
            CloseAt(cell);
            Until(cell, Close + 1);
            Assert.That(grip.Held, Is.EqualTo("box"));

            back = Back;
            Until(cell, Close + 3);

            Assert.That(grip.Held, Is.Null);
            Assert.That(Distance(Find(cell, "box").World, Place), Is.LessThan(1e-6), "the pose that its source reports");
            Assert.That(Find(cell, "box").UnknownMover, Is.Null, "the source of the object has restarted, too");
            Assert.That(grip.Fault, Is.EqualTo(value == 1 ? FrameMessages.SignalRestarted : null));
        }

        [Test]
        public void Source_RestartsWhileTheGripperIsClosed_CausesAFaultUntilTheNextChange()
        {
            var (cell, grip) = NewCell("box");
            var (back, value) = (0.0, 1);
            cell.Sampling = t =>
            {
                SendAll(cell, t - back, t);
                if (back > 0) cell.Send("grip", t - back, value);
            };
            CloseAt(cell);
            Until(cell, Close + 1);
            back = Back;
            Until(cell, Close + 3);
            Assert.That(grip.Fault, Is.Not.Null);

            value = 0;
            Until(cell, Close + 4);

            Assert.That(grip.Fault, Is.Null);
            Assert.That(grip.Held, Is.Null);
        }

        [TestCase(true)]
        [TestCase(false)]
        public void Source_RestartsAfterTheRelease_ObjectReturnsToTheReportedPose(bool isOfSignal)
        {
            var (cell, _) = NewCell("box");
            var back = 0.0;
            cell.Sampling = t =>
            {
                SendAll(cell, t - back, t);
                if (isOfSignal && back > 0) cell.Send("grip", t - back, 0);
            };
            CloseAt(cell);
            Until(cell, Open);
            cell.Send("grip", Open, 0);
            Until(cell, Open + 1);
            Assert.That(Distance(Find(cell, "box").World, Place), Is.GreaterThan(0.5));

            back = Back;
            Until(cell, Open + 3);

            Assert.That(Distance(Find(cell, "box").World, Place), Is.LessThan(1e-6), "the pose that its source reports");
            Assert.That(Find(cell, "box").UnknownMover, Is.Null, "its source has restarted, too");
        }

        // The object's source repeats a pose from before the grip, so the object is probably still where it was released.
        [Test]
        public void SourceOfTheSignal_RestartsAfterTheRelease_ObjectIsHeldUntilItsSourceReportsAnotherPose()
        {
            var (cell, _) = NewCell("box");
            var place = Place;
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, place);
            };
            CloseAt(cell);
            Until(cell, Open);
            cell.Send("grip", Open, 0);
            Until(cell, Open + 1);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));

            cell.Session.Listener.SignalsReceived(
                new SignalsMessage(ControlTime.FromSeconds(Close - Back), new SignalValue("grip", 0)), HeadsetTime.FromSeconds(cell.Now));
            Until(cell, Open + 2);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held));

            place = At(1.1, 0);
            Until(cell, Open + 3);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void ControlClock_Restarts_ObjectStaysHeldAndAFaultIsReported()
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t => SendAll(cell, t + cell.ClockStep, t);
            CloseAt(cell);
            Until(cell, Close + 1);
            var inHand = ToolOf(cell).Inverse * Find(cell, "box").World;

            cell.ClockStep = 7;
            Until(cell, Close + 4);

            Assert.That(grip.Held, Is.EqualTo("box"));
            Assert.That(Distance(ToolOf(cell).Inverse * Find(cell, "box").World, inHand), Is.LessThan(1e-6));
            Assert.That(grip.Fault, Is.EqualTo(FrameMessages.SignalRestarted), "the gripper may have opened and closed during the restart");
            var opened = cell.Now;
            cell.Send("grip", opened + cell.ClockStep, 0);
            Until(cell, opened + 1);
            Assert.That(grip.Fault, Is.Null);
            Assert.That(Distance(Find(cell, "box").World, Tool(Shoulder(opened)) * inHand), Is.LessThan(1e-6));
        }

        static PoseState StateOf(CellSession cell) => cell.Session.Frames.StateOf(Find(cell, "box"));

        static void SendAll(CellSession cell, double stamp, double t)
        {
            cell.SendJoints(stamp, Shoulder(t), 0);
            cell.Send("world", "box", stamp, Place);
        }

        static void CloseAt(CellSession cell)
        {
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
        }
    }
}
