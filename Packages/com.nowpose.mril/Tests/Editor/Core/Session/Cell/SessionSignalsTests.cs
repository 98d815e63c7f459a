using System;
using System.Collections.Generic;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    public class SessionSignalsTests
    {
        // With a negative delay, the control system sends the change before its stamp.
        [TestCase(-0.08)]
        [TestCase(0)]
        [TestCase(0.06)]
        [TestCase(0.25)]
        public void Signal_AnyMessageDelay_IsShownInTheFirstPossibleFrame(double delay)
        {
            const double frame = 1 / 60.0;
            double[] stamps = { 20.7, 20.96, 21.313, 21.32, 21.8 };
            var cell = new CellSession();
            cell.Send("grip", 19.5, 0);
            cell.Run(0.1);
            var shown = new List<(double Light, double Value)>();
            var light = 0.0;
            cell.Session.Signals.Table.Changed += signal => shown.Add((light, signal.Value));

            for (var sent = 0; cell.Now < 22.5; cell.Run(frame))
            {
                light = cell.Now + CellSession.Visu;
                for (; sent < stamps.Length && stamps[sent] + delay <= cell.Now; sent++)
                    cell.Session.Listener.SignalsReceived(
                        new SignalsMessage(ControlTime.FromSeconds(stamps[sent]), new SignalValue("grip", (sent + 1) % 2)),
                        HeadsetTime.FromSeconds(stamps[sent] + delay));
            }

            Assert.That(shown, Has.Count.EqualTo(stamps.Length));
            for (var i = 0; i < stamps.Length; i++)
            {
                Assert.That(shown[i].Value, Is.EqualTo((i + 1) % 2));
                // The display time of a frame that starts when the message arrives is one L_visu later.
                var possible = Math.Max(stamps[i], stamps[i] + delay + CellSession.Visu);
                Assert.That(shown[i].Light - possible, Is.InRange(-1e-4, frame + 1e-4), "change " + i);
            }
        }

        // For example, a counter at 1 kHz after a gap of the network.
        [Test]
        public void Show_MoreChangesAtOnceThanASignalKeeps_CountsTheDroppedOnes()
        {
            var cell = new CellSession();
            var seen = new List<double>();
            cell.Session.Signals.Table.Changed += signal => seen.Add(signal.Value);
            cell.Send("counter", 20, 0);
            cell.Run(1);

            for (var i = 1; i <= 100; i++) cell.Send("counter", 20.5 + 0.001 * i, i);
            cell.Run(1);

            Assert.That((seen.Count, cell.Session.Drops[DropReason.SlowReader]), Is.EqualTo((1 + 63, 37L)));
            Assert.That(seen, Is.Ordered);
            Assert.That(seen[seen.Count - 1], Is.EqualTo(100));
        }

        [Test]
        public void Signal_BeforeTheClockIsKnown_WaitsForTheClock()
        {
            var cell = new CellSession(isClockKnown: false);
            cell.Send("grip", 19.5, 1);
            cell.Run(0.2);
            Assert.That(cell.Session.Signals.Table.Count, Is.Zero);

            cell.Synchronise();
            cell.Run(0.1);

            Assert.That(ValueOf(cell, "grip"), Is.EqualTo(1));
        }

        [Test]
        public void Signal_ManyMessagesBeforeTheClockIsKnown_KeepsTheNewestValueOfEachSignal()
        {
            var cell = new CellSession(isClockKnown: false);
            cell.Send("grip", 15, 0);
            cell.Send("grip", 15.2, 1);
            cell.Send("grip", 15.1, 0); // arrives after a newer message
            cell.Send("door", 15, 1);
            for (var k = 0; k < 3000; k++) cell.Send("speed", 16 + 0.001 * k, k);
            cell.Run(0.2);

            cell.Synchronise();
            cell.Run(0.1);

            Assert.That((ValueOf(cell, "grip"), ValueOf(cell, "door"), ValueOf(cell, "speed")), Is.EqualTo((1.0, 1.0, 2999.0)));
        }

        // The handler runs between the values that did not fit into the queue and those that did. The message comes from the socket's thread.
        [Test]
        public void Show_MessageArrivesWhileTheValuesOfAFullQueueAreUsed_OldValueDoesNotReturn()
        {
            var cell = new CellSession(isClockKnown: false);
            for (var k = 0; k <= 1000; k++) cell.Send("grip", 15 + 0.002 * k, k);
            cell.Session.Signals.Judged += (in SignalValue value, ControlTime stamp, HeadsetTime arrival, DropReason reason) =>
            {
                if (value.Value == 0) cell.Send("grip", 17.5, 2000);
            };
            cell.Synchronise();

            cell.Run(0.1);

            Assert.That(ValueOf(cell, "grip"), Is.EqualTo(2000));
        }

        [Test]
        public void Signal_MoreSignalsThanAllowedBeforeTheClockIsKnown_AreDroppedAndCounted()
        {
            var cell = new CellSession(isClockKnown: false);
            for (var k = 0; k < ProtocolLimits.Signals + 7; k++) cell.Send("s" + k, 15, k);
            for (var k = 0; k < 1000; k++) cell.Send("s0", 16 + 0.001 * k, k);

            cell.Synchronise();
            cell.Run(0.1);

            Assert.That(cell.Session.Signals.Table.Count, Is.EqualTo(ProtocolLimits.Signals));
            Assert.That(cell.Session.Drops[DropReason.TooManySignals], Is.EqualTo(7));
        }

        [Test]
        public void Signal_MoreSignalsThanAllowedAfterSourcesEnded_ReplacesTheSignalsOfEndedSourcesOnly()
        {
            var cell = new CellSession();
            for (var k = 0; k < ProtocolLimits.Signals; k++) cell.Send("old" + k, 19.5, k);
            cell.Run(0.1);
            var end = ControlTime.FromSeconds(19.6);
            cell.Session.Listener.SignalStatusReceived(
                new JointStatusMessage(new[]
                {
                    new JointReport("old0", JointDataState.Stale, end, "its source has ended"),
                    new JointReport("old1", JointDataState.Fault, end, "the server no longer has this node"),
                    new JointReport("old7", JointDataState.Stale, end, "its source has ended"),
                }), default);

            for (var k = 0; k < 3; k++) cell.Send("new" + k, 19.7, k + 0.5);
            cell.Run(0.1);

            Assert.That((ValueOf(cell, "new0"), ValueOf(cell, "new1"), ValueOf(cell, "old1"), ValueOf(cell, "old8")), Is.EqualTo((0.5, 1.5, 1.0, 8.0)));
            Assert.That(cell.Session.Signals.Table.Find("old7"), Is.Null);
            Assert.That(cell.Session.Signals.FaultOf("old7", isConnected: true).Reason, Is.EqualTo("its source has ended"));
            Assert.That(cell.Session.Signals.FaultOf("new1", isConnected: true).Reason, Is.Null);
            Assert.That(cell.Session.Drops[DropReason.TooManySignals], Is.EqualTo(1));
        }

        // A restarted gateway has no list of the sources that ended before its start.
        [Test]
        public void Signal_FullTableAfterAReconnection_HoldsAllSignalsOfTheNewConnection()
        {
            var cell = new CellSession();
            for (var k = 0; k < ProtocolLimits.Signals; k++) cell.Send("s" + k, 19.5, k);
            cell.Run(0.1);
            cell.Session.Cell.Connection.Set(HeadsetTime.FromSeconds(cell.Now));

            cell.Send("new", cell.Now, 0.5);
            for (var k = 0; k < ProtocolLimits.Signals - 1; k++) cell.Send("s" + k, cell.Now, k);
            cell.Run(0.1);

            Assert.That(cell.Session.Drops[DropReason.TooManySignals], Is.Zero);
            Assert.That(ValueOf(cell, "new"), Is.EqualTo(0.5));
            for (var k = 0; k < ProtocolLimits.Signals - 1; k++) Assert.That(ValueOf(cell, "s" + k), Is.EqualTo(k));
            cell.Send("s" + (ProtocolLimits.Signals - 1), cell.Now, 1);
            cell.Run(0.1);
            Assert.That(cell.Session.Drops[DropReason.TooManySignals], Is.EqualTo(1));
        }

        [Test]
        public void Signal_StampInTheFuture_IsDroppedAndCounted()
        {
            var cell = new CellSession();
            cell.Session.Listener.SignalsReceived(
                new SignalsMessage(ControlTime.FromSeconds(60), new SignalValue("grip", 1)), HeadsetTime.FromSeconds(20));

            cell.Run(0.2);

            Assert.That(cell.Session.Drops[DropReason.StampInFuture], Is.EqualTo(1));
        }

        // The new source may have had its value since before the last change of the former source. A small difference could also be that of a message
        // that was overtaken.
        [TestCase(10, true)]
        [TestCase(0.3, true)]
        [TestCase(0.3, false)]
        public void Signal_ValueOfANewSourceIsOlderThanTheFormerValue_IsShown(double older, bool isSameConnection)
        {
            var cell = new CellSession();
            cell.Reconnect();
            cell.Send("grip", 19.9, 1);
            cell.Run(0.3);
            if (isSameConnection)
                foreach (var reports in new[] { new[] { new JointReport("grip", JointDataState.Stale, ControlTime.FromSeconds(cell.Now), "its source has ended") },
                             Array.Empty<JointReport>() })
                    cell.Session.Listener.SignalStatusReceived(new JointStatusMessage(reports), HeadsetTime.FromSeconds(cell.Now));
            else cell.Reconnect();
            cell.Run(0.1);

            cell.Session.Listener.SignalsReceived(
                new SignalsMessage(ControlTime.FromSeconds(19.9 - older), new SignalValue("grip", 0)), HeadsetTime.FromSeconds(cell.Now));
            cell.Run(0.1);

            Assert.That((ValueOf(cell, "grip"), cell.Session.Signals.FaultOf("grip", isConnected: true).Reason), Is.EqualTo((0.0, (string)null)));
        }

        [Test]
        public void Signal_OlderValuesOfANewSourceWaitForTheClock_ShowsTheNewestOfThem()
        {
            var cell = new CellSession(isClockKnown: false);
            cell.Send("grip", 19, 1);
            cell.Send("grip", 15, 0);
            for (var k = 0; k < 1000; k++) cell.Send("speed", 16 + 0.001 * k, k);

            cell.Synchronise();
            cell.Run(0.1);

            Assert.That(ValueOf(cell, "grip"), Is.Zero);
        }

        [Test]
        public void FaultOf_EachState_IsNamed()
        {
            var cell = new CellSession();
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.EqualTo(SignalMessages.NoValue));
            cell.Send("grip", 19.5, 1);
            cell.Run(0.1);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.Null);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: false).Reason, Is.EqualTo(SignalMessages.NoConnection));
            cell.Session.Signals.Show(new DisplayMoment(), isConnected: true);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.EqualTo(SignalMessages.ClockUnsynchronised));
            cell.Run(0.2);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.Null);

            var end = ControlTime.FromSeconds(12);
            cell.Session.Listener.SignalStatusReceived(
                new JointStatusMessage(new[] { new JointReport("grip", JointDataState.Stale, end, "its source has ended") }), default);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.EqualTo("its source has ended"));
            Assert.That((cell.Session.Signals.FaultOf("grip", isConnected: true).Since, cell.Session.Signals.FaultOf("door", isConnected: true).Since),
                Is.EqualTo(((ControlTime?)end, (ControlTime?)null)));

            cell.Session.Listener.SignalStatusReceived(new JointStatusMessage(Array.Empty<JointReport>()), default);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.Null);
        }

        [Test]
        public void FaultOf_NoConnectionThenValueOlderThanTheConnection_IsTheFirstFrameThenTheStartOfTheConnection()
        {
            var cell = new CellSession();
            double Since(bool isConnected) => cell.Session.Signals.FaultOf("grip", isConnected).Since?.SinceEpoch.TotalSeconds ?? double.NaN;
            cell.Run(1);
            Assert.That(cell.Session.CanReceiveSignals, Is.False);
            Assert.That(Since(isConnected: false), Is.EqualTo(20 + CellSession.Visu).Within(1e-3));

            cell.Send("grip", 20.9, 1);
            cell.Run(1);
            Assert.That((Since(isConnected: true), Since(isConnected: false)), Is.EqualTo((double.NaN, double.NaN)));

            var start = cell.Now;
            cell.Reconnect();
            cell.Run(1);
            Assert.That(Since(isConnected: true), Is.EqualTo(start).Within(1e-3));
        }

        // Values wait for the clock, so a value that is not known yet may already have arrived.
        [Test]
        public void FaultOf_NoValueWhileTheClockIsUnknown_NamesTheClock()
        {
            var cell = new CellSession(isClockKnown: false);
            cell.Run(0.1);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.EqualTo(SignalMessages.ClockUnsynchronised));

            cell.Synchronise();
            cell.Run(0.1);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.EqualTo(SignalMessages.NoValue));
        }

        [Test]
        public void CanReceiveSignals_ConnectionRequestedButNotOpen_IsFalse()
        {
            var cell = new CellSession();
            Assert.That(cell.Session.CanReceiveSignals, Is.False, "no program has supplied a value");
            cell.Send("grip", 19.5, 1);
            cell.Run(0.1);
            Assert.That(cell.Session.CanReceiveSignals, Is.True, "a program supplies the values");

            cell.Session.Connect();
            cell.Session.Dispose();

            Assert.That(cell.Session.CanReceiveSignals, Is.False);
        }

        static double ValueOf(CellSession cell, string signal) => cell.Session.Signals.Table.Find(signal).Value;
    }
}
