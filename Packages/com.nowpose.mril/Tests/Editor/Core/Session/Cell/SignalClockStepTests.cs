using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests of signals whose stamps do not match the control time that the headset knows.</summary>
    public class SignalClockStepTests
    {
        // The headset still has the former control time when the value arrives, and the source does not repeat the value.
        [TestCase(3600, true)]
        [TestCase(3600, false)]
        public void Signal_BetweenAClockStepAndTheNextExchanges_IsNotCurrentUntilItIsShown(double step, bool isKnownBefore)
        {
            var cell = new CellSession();
            if (isKnownBefore) cell.Send("grip", 19.5, 0);
            cell.Run(0.5);
            cell.Reconnect();
            cell.ClockStep = step;

            SendNow(cell, "grip", 1);
            cell.Session.Tick(HeadsetTime.FromSeconds(cell.Now));
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.EqualTo(SignalMessages.StampMismatch));
            cell.Run(8);

            Assert.That(cell.Session.Clock.Steps, Is.EqualTo(1));
            Assert.That(ValueOf(cell, "grip"), Is.EqualTo(1));
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.Null);
        }

        [Test]
        public void FaultOf_ValueWithAValidStampAfterOneInTheFuture_IsNull()
        {
            var cell = new CellSession();
            cell.ClockStep = 60;
            SendNow(cell, "grip", 1);
            cell.ClockStep = 0;
            cell.Run(0.1);
            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true).Reason, Is.EqualTo(SignalMessages.StampMismatch));

            SendNow(cell, "grip", 0.5);
            cell.Run(0.2);

            Assert.That((ValueOf(cell, "grip"), cell.Session.Signals.FaultOf("grip", isConnected: true).Reason), Is.EqualTo((0.5, (string)null)));
        }

        [Test]
        public void FaultOf_ValueInTheFutureThenANewConnection_HasNoStart()
        {
            var cell = new CellSession();
            cell.Send("grip", 19.5, 1);
            cell.Run(0.5);
            cell.ClockStep = 60;
            SendNow(cell, "grip", 0);
            cell.ClockStep = 0;
            cell.Run(0.1);

            cell.Reconnect();
            cell.Run(0.1);

            Assert.That(cell.Session.Signals.FaultOf("grip", isConnected: true), Is.EqualTo((SignalMessages.StampMismatch, (ControlTime?)null)));
        }

        /// <summary>Sends a value with the current control time.</summary>
        static void SendNow(CellSession cell, string signal, double value) => cell.Session.Listener.SignalsReceived(
            new SignalsMessage(ControlTime.FromSeconds(cell.Now + cell.ClockStep), new SignalValue(signal, value)), HeadsetTime.FromSeconds(cell.Now));

        static double ValueOf(CellSession cell, string signal) => cell.Session.Signals.Table.Find(signal).Value;
    }
}
