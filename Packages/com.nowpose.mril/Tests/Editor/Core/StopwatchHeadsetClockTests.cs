using System;
using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class StopwatchHeadsetClockTests
    {
        readonly StopwatchHeadsetClock _clock = new StopwatchHeadsetClock();

        [Test]
        public void At_CountBetweenTwoReadings_ReturnsATimeBetweenThem()
        {
            var before = _clock.Now;
            var count = Stopwatch.GetTimestamp();
            var after = _clock.Now;

            Assert.That(_clock.At(count).SinceEpoch, Is.InRange(before.SinceEpoch, after.SinceEpoch));
        }

        [TestCase(0)]
        [TestCase(1_000_000)]
        public void At_CountsOneSecondApart_DifferByOneSecondAtAnyUpTime(long seconds)
        {
            var count = seconds * Stopwatch.Frequency + 3;

            Assert.That(_clock.At(count + Stopwatch.Frequency) - _clock.At(count), Is.EqualTo(TimeSpan.FromSeconds(1)));
            Assert.That((_clock.At(count) - _clock.At(0)).TotalSeconds, Is.EqualTo(seconds).Within(1e-6));
        }
    }
}
