using System;
using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Signals;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Signals
{
    /// <summary>Tests that the first value after an interruption is reported as such, because the signal may have changed unnoticed.</summary>
    public class InterruptedSignalTests
    {
        static ControlTime At(double seconds) => ControlTime.FromSeconds(seconds);

        [TestCase(1, 11, true)]
        [TestCase(0, 11, true)]
        [TestCase(1, 10, false)]
        [TestCase(1, 9.5, true)]
        [TestCase(1, 5, true)]
        [TestCase(0, 5, true)]
        public void Next_FirstValueAfterAnInterruption_IsResumedOnceIfItsStampIsNew(double value, double stamp, bool isResumed)
        {
            var (signal, resumed) = NewSignal();

            signal.Interrupt();
            signal.Add(At(stamp), value);
            while (signal.Next(At(stamp - 0.1))) { }
            Assert.That(resumed, Is.Empty);
            Assert.That(signal.Next(At(11)), Is.EqualTo(value != 1));
            signal.Add(At(12), value);
            Assert.That(signal.Next(At(12)), Is.False);

            Assert.That(resumed, Is.EqualTo(isResumed ? new[] { value } : Array.Empty<double>()));
        }

        [Test]
        public void Next_TimesInvalidBetweenAnInterruptionAndTheNextValue_IsResumedOnce([Values(0, 1)] double value)
        {
            var (signal, resumed) = NewSignal();

            signal.Interrupt();
            signal.Restart();
            while (signal.Next(At(5))) { }
            Assert.That(resumed, Is.Empty);
            signal.Add(At(6), value);
            while (signal.Next(At(6))) { }

            Assert.That(resumed, Is.EqualTo(new[] { value }));
        }

        [Test]
        public void Restart_FirstValueAfterAnInterruptionIsNotVisibleYet_IsResumedOnce([Values(0, 1)] double value, [Values(false, true)] bool isInFuture)
        {
            var (signal, resumed) = NewSignal();

            signal.Interrupt();
            if (isInFuture) signal.AddFuture(value);
            else signal.Add(At(11), value);
            signal.Restart();
            while (signal.Next(At(5))) { }
            signal.Add(At(6), value);
            while (signal.Next(At(6))) { }

            Assert.That(resumed, Is.EqualTo(new[] { value }));
            Assert.That(signal.Value, Is.EqualTo(value));
        }

        [Test]
        public void Next_ValueInTheFutureAfterAnInterruption_TheNextValueIsResumed([Values(0, 1)] double value)
        {
            var (signal, resumed) = NewSignal();

            signal.Interrupt();
            signal.AddFuture(1);
            signal.Add(At(11), value);
            while (signal.Next(At(11))) { }

            Assert.That(resumed, Is.EqualTo(new[] { value }));
        }

        // The values wait for their display time, and the oldest of them are removed.
        [Test]
        public void Next_MoreChangesThanAreKeptAfterAnInterruption_IsResumedOnce()
        {
            var (signal, resumed) = NewSignal();

            signal.Interrupt();
            for (var k = 0; k < 1000; k++) signal.Add(At(11 + k), k % 2);
            while (signal.Next(At(2000))) { }

            Assert.That(resumed, Has.Count.EqualTo(1));
        }

        // The signal may have changed in the meantime, also if the next value that is kept is the visible one.
        [Test]
        public void Next_ChangesAreDroppedBecauseTooManyWait_IsResumedOnce([Values(65, 66)] int count)
        {
            var (signal, resumed) = NewSignal();

            for (var k = 0; k < count; k++) signal.Add(At(11 + k), k % 2);
            while (signal.Next(At(2000))) { }

            Assert.That(resumed, Has.Count.EqualTo(1));
        }

        // A measured width changes with each message. Only a change to the other side of 0.5 opens or closes the gripper.
        [TestCase(0.9, -1, false)]
        [TestCase(0.9, 5, true)]
        [TestCase(0.9, 37, false)]
        [TestCase(0.4, 99, true)]
        public void Next_ValuesAreDroppedBecauseTooManyWait_IsResumedIfTheGripperMayHaveSwitched(double next, int switched, bool isResumed)
        {
            var (signal, resumed) = NewSignal();

            for (var k = 0; k < 100; k++) signal.Add(At(11 + 0.001 * k), k == switched ? 0.3 : next + 0.001 * (k % 7));
            while (signal.Next(At(12))) { }

            Assert.That(resumed, Has.Count.EqualTo(isResumed ? 1 : 0));
        }

        // The late change is older than all changes that wait, so it is the one that newer changes replace.
        [Test]
        public void Add_LateChangeToAFullList_DropsTheLateChange()
        {
            var (signal, resumed) = NewSignal();
            for (var k = 0; k < 63; k++) signal.Add(At(11 + 0.01 * k), k + 2);

            signal.Add(At(10.9), 0);
            while (signal.Next(At(11.005))) { }

            Assert.That((signal.Value, signal.Since), Is.EqualTo((2.0, (ControlTime?)At(11))));
            Assert.That(resumed, Is.EqualTo(new[] { 2.0 }));
        }

        static (SignalTrack Signal, List<double> Resumed) NewSignal()
        {
            var signal = new SignalTrack("grip");
            var resumed = new List<double>();
            signal.Resumed += each => resumed.Add(each.Value);
            signal.Add(At(9), 1);
            signal.Add(At(10), 1);
            while (signal.Next(At(10))) { }
            return (signal, resumed);
        }
    }
}
