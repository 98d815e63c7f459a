using System;
using System.Collections.Generic;
using NUnit.Framework;
using Nowpose.Protocol;
using Nowpose.Signals;

namespace Nowpose.Tests.Core.Signals
{
    public class SignalTrackTests
    {
        static ControlTime At(double seconds) => ControlTime.FromSeconds(seconds);

        [Test]
        public void Next_DisplayTimeBeforeTheStamp_ShowsNothing()
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10), 1);

            Assert.That(signal.Next(At(9.999)), Is.False);
            Assert.That((signal.IsKnown, signal.Value, signal.Since), Is.EqualTo((false, 0.0, (ControlTime?)null)));
            Assert.That(signal.Next(At(10)), Is.True);
            Assert.That((signal.IsKnown, signal.Value, signal.Since), Is.EqualTo((true, 1.0, (ControlTime?)At(10))));
        }

        [Test]
        public void Next_SeveralChanges_AreShownInTheOrderOfTheirStamps()
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10.2), 0.5);
            signal.Add(At(10), 1);
            signal.Add(At(10.1), 0);

            foreach (var (time, value) in new[] { (10, 1.0), (10.1, 0.0), (10.2, 0.5) })
            {
                Assert.That(signal.Next(At(20)), Is.True);
                Assert.That((signal.Since, signal.Value), Is.EqualTo(((ControlTime?)At(time), value)));
            }
            Assert.That(signal.Next(At(20)), Is.False);
        }

        [Test]
        public void Add_SameValueAgain_IsNotAChange()
        {
            var signal = new SignalTrack("grip");
            for (var k = 0; k < 500; k++) Assert.That(signal.Add(At(10 + 0.01 * k), 1), Is.EqualTo(DropReason.None));

            Assert.That(signal.Next(At(20)), Is.True);
            Assert.That((signal.Since, signal.Newest), Is.EqualTo(((ControlTime?)At(10), (ControlTime?)At(14.99))));
            Assert.That(signal.Next(At(20)), Is.False);
        }

        [TestCase(0.02)]
        [TestCase(0.2)]
        public void Add_AnnouncedChangeThenOrdinaryValues_IsShownAtItsStamp(double latency)
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10), 0, At(10 + latency));
            signal.Next(At(10));

            signal.Add(At(10.91), 1, At(10.1 + latency));
            for (var k = 2; k < 30; k++) Assert.That(signal.Add(At(10 + 0.05 * k), k < 19 ? 0 : 1, At(10 + 0.05 * k + latency)), Is.EqualTo(DropReason.None));

            Assert.That(signal.Next(At(10.909)), Is.False);
            Assert.That((signal.Next(At(10.91)), signal.Value, signal.Since), Is.EqualTo((true, 1.0, (ControlTime?)At(10.91))));
        }

        [Test]
        public void Add_ClockSlightlyAheadThenBack_RestartsTheSignal()
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(9.9), 0, At(9.95));
            for (var k = 0; k < 100; k++) signal.Add(At(10 + 0.1 * k), 0, At(9.985 + 0.1 * k));
            signal.Next(At(20));

            for (var k = 0; k < 10; k++) signal.Add(At(15 + 0.1 * k), 1, At(20.005 + 0.1 * k));

            Assert.That((signal.Next(At(21)), signal.Value), Is.EqualTo((true, 1.0)));
        }

        [Test]
        public void Add_ClockOfASourceThatIsAheadGoesBack_RestartsTheSignal()
        {
            var signal = new SignalTrack("grip");
            var restarts = 0;
            signal.Restarted += _ => restarts++;
            for (var k = 0; k < 10; k++) signal.Add(At(10.5 + 0.05 * k), 0, At(10 + 0.05 * k));
            signal.Next(At(11));

            for (var k = 10; k < 16; k++) signal.Add(At(5 + 0.05 * k), 1, At(10 + 0.05 * k));

            Assert.That(restarts, Is.EqualTo(1));
            Assert.That((signal.Next(At(10.8)), signal.Value), Is.EqualTo((true, 1.0)));
        }

        [Test]
        public void Add_EarlierStampOfAWaitingChange_MovesTheChangeToTheEarlierStamp()
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10.2), 1);
            signal.Add(At(10.1), 1);

            Assert.That(signal.Next(At(10.1)), Is.True);
            Assert.That(signal.Next(At(20)), Is.False);
        }

        [TestCase(3)] // the change arrives while the first value is visible
        [TestCase(6)] // the change arrives when the repeated value should be visible
        public void Add_OvertakenChangeBeforeARepeatedValue_ReturnsToTheRepeatedValue(double displayed)
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(3), 1);
            signal.Add(At(5), 1);
            signal.Next(At(displayed));

            signal.Add(At(4), 0);

            Assert.That((signal.Next(At(6)), signal.Since, signal.Value), Is.EqualTo((true, (ControlTime?)At(4), 0.0)));
            Assert.That((signal.Next(At(6)), signal.Since, signal.Value), Is.EqualTo((true, (ControlTime?)At(5), 1.0)));
            Assert.That(signal.Next(At(6)), Is.False);
        }

        // Each message contains the true value at its stamp. In any order of arrival, the last visible value is that of the newest
        // stamp, and no value is shown twice in succession.
        [Test]
        public void Add_AnyOrderOfTrueValues_EndsWithTheNewestAndShowsChangesOnly([Range(1, 200)] int seed)
        {
            var random = new Random(seed);
            var messages = new List<(double Stamp, double Value, double Order)>();
            for (var k = 0; k < 30; k++) messages.Add((10 + 0.01 * k, random.Next(2), 10 + 0.01 * k + 0.03 * random.NextDouble()));
            messages.Sort((a, b) => a.Order.CompareTo(b.Order));
            var signal = new SignalTrack("grip");
            var before = double.NaN;

            foreach (var message in messages)
            {
                signal.Add(At(message.Stamp), message.Value);
                for (; signal.Next(At(message.Order - 0.05)); before = signal.Value)
                    Assert.That(signal.Value, Is.Not.EqualTo(before));
            }
            for (; signal.Next(At(20)); before = signal.Value) Assert.That(signal.Value, Is.Not.EqualTo(before));

            Assert.That(signal.Value, Is.EqualTo(messages.Find(each => each.Stamp == 10 + 0.01 * 29).Value));
        }

        [TestCase(100, 1, 1)] // more than the maximum by which messages are overtaken
        [TestCase(0.5, 0.01, 3)]
        [TestCase(0.2, 0.01, 5)] // so small that overtaken messages could be the cause
        public void Add_StampsOfTheSourceGoBack_RestartsWithTheLateValues(double step, double interval, int needed)
        {
            var signal = new SignalTrack("grip");
            var restarts = 0;
            signal.Restarted += _ => restarts++;
            signal.Add(At(1000), 1);
            signal.Next(At(1000));
            var start = 1000 - step;

            for (var k = 0; k < needed - 1; k++) signal.Add(At(start + k * interval), k % 2);
            Assert.That((restarts, signal.Next(At(1000)), signal.Value), Is.EqualTo((0, false, 1.0)));
            Assert.That(signal.Add(At(start + (needed - 1) * interval), (needed - 1) % 2), Is.EqualTo(DropReason.None));
            Assert.That((restarts, signal.Value, signal.Since), Is.EqualTo((1, 1.0, (ControlTime?)null)));

            for (var k = 0; k < needed; k++)
                Assert.That((signal.Next(At(1000)), signal.Since, signal.Value), Is.EqualTo((true, (ControlTime?)At(start + k * interval), (double)(k % 2))));
            Assert.That(signal.Next(At(1000)), Is.False);
            Assert.That(signal.Add(At(start + needed * interval), 0.5), Is.EqualTo(DropReason.None));
            Assert.That((signal.Next(At(1000)), signal.Value, restarts), Is.EqualTo((true, 0.5, 1)));
        }

        [Test]
        public void Add_StampsGoBackWhileTheValueRepeats_ShowsTheNextChangeAtItsNewStamp()
        {
            var signal = new SignalTrack("grip");
            for (var k = 0; k < 100; k++) signal.Add(At(900 + k), 1);
            signal.Next(At(1000));

            for (var k = 0; k < 20; k++) signal.Add(At(950 + k), k < 10 ? 1 : 0);
            while (signal.Next(At(1000))) { }

            Assert.That((signal.Since, signal.Value), Is.EqualTo(((ControlTime?)At(960), 0.0)));
        }

        // A source that publishes only changes may have no other value for hours.
        [Test]
        public void Add_OneValueOlderThanAnyOvertakenMessage_RestartsOnlyIfItContradictsTheKnownValues()
        {
            var signal = new SignalTrack("grip");
            var restarts = 0;
            signal.Restarted += _ => restarts++;
            signal.Add(At(1000), 1);
            signal.Add(At(1009), 1);
            signal.Next(At(1009));

            Assert.That((signal.Add(At(1001), 1), restarts), Is.EqualTo((DropReason.None, 0)), "the signal had this value at that time");
            Assert.That((signal.Add(At(990), 0), restarts), Is.EqualTo((DropReason.None, 1)));
            Assert.That((signal.Next(At(1009)), signal.Value, signal.Since), Is.EqualTo((true, 0.0, (ControlTime?)At(990))));
        }

        [Test]
        public void Add_SingleOldMessagesAmongNewOnes_DoNotRestart()
        {
            var signal = new SignalTrack("grip");
            var restarts = 0;
            signal.Restarted += _ => restarts++;
            for (var k = 0; k < 100; k++)
            {
                signal.Add(At(1000 + 0.1 * k), k % 2);
                signal.Next(At(1000 + 0.1 * k));
                if (k % 5 < 2) signal.Add(At(999.3 + 0.1 * k), 0.5);
            }

            Assert.That((restarts, signal.Value), Is.EqualTo((0, 1.0)));
        }

        [TestCase(0.2, null, 1)]
        [TestCase(0.3, 0.5, 0.5)]
        public void Restart_AfterALateValue_ShowsItOnlyIfItCannotHaveBeenOvertaken(double lateBy, double? unplaced, double shown)
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10), 0);
            signal.Add(At(11), 1);
            while (signal.Next(At(12))) { }

            Assert.That(signal.Add(At(11 - lateBy), 0.5), Is.EqualTo(DropReason.LateSample));
            Assert.That(signal.Unplaced, Is.EqualTo(unplaced));
            signal.Restart();
            while (signal.Next(At(1))) { }

            Assert.That((signal.Value, signal.Unplaced), Is.EqualTo((shown, (double?)null)));
        }

        [Test]
        public void Next_WaitingChangeCorrectedToTheVisibleValue_IsNotAChange()
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10), 1);
            signal.Next(At(10));
            signal.Add(At(11), 0);
            signal.Add(At(11), 1);

            Assert.That(signal.Next(At(12)), Is.False);
            Assert.That((signal.Since, signal.Value), Is.EqualTo(((ControlTime?)At(10), 1.0)));
            signal.Add(At(10.5), 0); // overtaken
            while (signal.Next(At(12))) { }
            Assert.That((signal.Since, signal.Value), Is.EqualTo(((ControlTime?)At(11), 1.0)));
        }

        [Test]
        public void Add_OlderThanTheVisibleChange_IsLate()
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10), 1);
            signal.Next(At(10));

            Assert.That(signal.Add(At(9), 0), Is.EqualTo(DropReason.LateSample));
            Assert.That(signal.Add(At(10), 1), Is.EqualTo(DropReason.DuplicateSample));
            Assert.That((signal.Next(At(10)), signal.Value), Is.EqualTo((false, 1.0)));
        }

        [Test]
        public void Add_MoreChangesThanAreKept_KeepsTheVisibleOneAndTheNewest()
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(1), 7);
            signal.Next(At(1));
            for (var k = 0; k < 1000; k++) signal.Add(At(10 + k), k % 2);

            Assert.That(signal.Value, Is.EqualTo(7));
            while (signal.Next(At(2000))) { }
            Assert.That((signal.Since, signal.Value), Is.EqualTo(((ControlTime?)At(1009), 1.0)));
        }
    }
}
