using System;
using System.Globalization;
using Nowpose.Counter;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class CounterPairingTests
    {
        const long Day = 86_400;
        const long StopwatchHz = 10_000_000;

        static CounterPairing Measure(PlayedCounters device)
        {
            Assert.That(CounterPairing.TryMeasure(() => device.Counter, device.Stopwatch, out var pairing, out var fault), Is.True, fault);
            return pairing;
        }

        // Returns the stopwatch reading that corresponds to a count, in units of 100 ns. Decimal arithmetic keeps 28 digits.
        static long Expected(long count, long frequency, decimal lag) =>
            decimal.ToInt64(decimal.Floor(((decimal)count / frequency - lag) * StopwatchHz));

        [Test]
        public void ToTarget_AnyFrequencyAndUpTime_EqualsTheStopwatch(
            [Values(10_000_000, 19_200_000, 24_000_000, 1_015_592)] long frequency,
            [Values(0, 90 * Day, 1000 * Day)] long upTimeSeconds,
            [Values(0.0, 1234.5678901)] double stopwatchLagSeconds,
            [Values(-0.02, 0.0, 0.047, 3600.0)] double aheadSeconds)
        {
            var lag = (decimal)stopwatchLagSeconds;
            var pairing = Measure(new PlayedCounters(frequency, upTimeSeconds + lag, lag));
            var count = (long)((upTimeSeconds + lag + (decimal)aheadSeconds) * frequency);

            var reading = pairing.ToTarget(count);

            var bound = pairing.Uncertainty.Ticks + 1;
            Assert.That(reading, Is.InRange(Expected(count, frequency, lag) - bound, Expected(count, frequency, lag) + bound));
            Assert.That(pairing.Uncertainty.TotalMilliseconds, Is.LessThan(0.003), "two readings plus one period of the slowest counter");
        }

        // Earlier versions used the count as a stopwatch reading, so the display time was wrong.
        [TestCase(19_200_000)]
        [TestCase(24_000_000)]
        [TestCase(1_015_592)]
        public void ToTarget_CounterWithAnotherFrequency_DiffersFromTheCount(long frequency)
        {
            var pairing = Measure(new PlayedCounters(frequency, 3600, 0));
            var count = 3600 * frequency;

            Assert.That(Math.Abs(count - pairing.ToTarget(count)) / (double)StopwatchHz, Is.GreaterThan(3000), "seconds");
        }

        [TestCase(19_200_000)]
        [TestCase(1_015_592)]
        public void ToTarget_TwoCounts_PreservesTheIntervalAtAnyUpTime(long frequency)
        {
            var pairing = Measure(new PlayedCounters(frequency, 500 * Day, 0));
            var start = 500 * Day * frequency + 12_345;

            for (var seconds = 1L; seconds < 100 * Day; seconds *= 10)
            {
                var length = pairing.ToTarget(start + seconds * frequency) - pairing.ToTarget(start);
                Assert.That(length, Is.EqualTo(seconds * StopwatchHz).Within(1), $"{seconds} s");
            }
        }

        [Test]
        public void TryMeasure_InterruptedReadings_UsesTheShortestBracket()
        {
            // A bracket consists of three readings: counter, stopwatch, counter. One bracket in eight has no pause; the others have pauses of 1 to 16
            // ms.
            var device = new PlayedCounters(24_000_000, 90 * Day, 17) { PauseAfter = i => i / 3 % 8 == 5 ? 0 : 0.001 * (1 + i % 16) };

            var pairing = Measure(device);

            var count = (90 * Day + 1) * 24_000_000;
            Assert.That(pairing.ToTarget(count), Is.EqualTo(Expected(count, 24_000_000, 17)).Within(pairing.Uncertainty.Ticks + 1));
            Assert.That(pairing.Uncertainty.TotalMilliseconds, Is.LessThan(0.001));
            Assert.That(device.Readings, Is.LessThanOrEqualTo(100));
        }

        [Test]
        public void TryMeasure_EveryReadingInterrupted_ErrorIsWithinTheUncertainty()
        {
            // The pause falls between the stopwatch and the second count, which makes the bracket as asymmetric as possible.
            var device = new PlayedCounters(24_000_000, 90 * Day, 0) { PauseAfter = i => i % 3 == 1 ? 0.004 : 0 };

            var pairing = Measure(device);

            var count = 90 * Day * 24_000_000;
            var error = TimeSpan.FromTicks(Math.Abs(pairing.ToTarget(count) - Expected(count, 24_000_000, 0)));
            Assert.That(error, Is.LessThanOrEqualTo(pairing.Uncertainty));
            Assert.That(error.TotalMilliseconds, Is.GreaterThan(1), "the pauses increase the error");
        }

        [Test]
        public void TryMeasure_LibraryMissing_ReturnsFalseAndTheFault()
        {
            var isPaired = CounterPairing.TryMeasure(
                () => throw new DllNotFoundException("kernel32.dll"), new StopwatchCounter(), out var pairing, out var fault);

            Assert.That(isPaired, Is.False);
            Assert.That(pairing, Is.Null);
            Assert.That(fault, Is.EqualTo(CounterMessages.Missing("kernel32.dll")));
        }

        [TestCase(0)]
        [TestCase(-5)]
        [TestCase(long.MaxValue)]
        public void TryMeasure_InvalidFrequency_ReturnsFalseAndTheFault(long frequency)
        {
            var device = new PlayedCounters(10_000_000, 10, 0);

            var isPaired = CounterPairing.TryMeasure(() => new FaultyCounter(frequency, 0), device.Stopwatch, out _, out var fault);

            Assert.That(isPaired, Is.False);
            Assert.That(fault, Does.Contain(frequency.ToString(CultureInfo.InvariantCulture) + " Hz"));
        }

        [Test]
        public void TryMeasure_CounterGoesBack_ReturnsFalseAndTheFault()
        {
            var device = new PlayedCounters(10_000_000, 10, 0);

            var isPaired = CounterPairing.TryMeasure(() => new FaultyCounter(10_000_000, -1), device.Stopwatch, out _, out var fault);

            Assert.That(isPaired, Is.False);
            Assert.That(fault, Is.EqualTo(CounterMessages.WentBack(CounterPairing.Brackets)));
        }

        [TestCase(long.MaxValue)]
        [TestCase(long.MinValue)]
        public void ToTarget_ExtremeCount_DoesNotThrow(long count)
        {
            var pairing = Measure(new PlayedCounters(1_015_592, 10, 0));

            Assert.That(() => pairing.ToTarget(count), Throws.Nothing);
        }

        // On Windows, this test reads the real counters. Other systems have no such counter.
        [Test]
        public void TryMeasure_CountersOfThisMachine_SucceedsOrReturnsTheFault()
        {
            var stopwatch = new StopwatchCounter();

            if (!CounterPairing.TryMeasure(() => new WindowsPerformanceCounter(), stopwatch, out var pairing, out var fault))
            {
                Assert.That(fault, Does.StartWith(CounterMessages.Missing("|").Split('|')[0]));
                return;
            }
            var before = stopwatch.Read();
            var reading = pairing.ToTarget(new WindowsPerformanceCounter().Read());
            var after = stopwatch.Read();
            var bound = pairing.Uncertainty.TotalSeconds * stopwatch.Frequency + 1;
            Assert.That(reading, Is.InRange(before - bound, after + bound));
        }

        sealed class FaultyCounter : ICounter
        {
            readonly long _step;
            long _count = 1_000_000_000;

            public FaultyCounter(long frequency, long step) => (Frequency, _step) = (frequency, step);

            public long Frequency { get; }

            public long Read() => _count += _step;
        }
    }
}
