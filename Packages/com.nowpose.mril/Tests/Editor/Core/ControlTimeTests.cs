using System;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class ControlTimeTests
    {
        [TestCase(0L)]
        [TestCase(100L)]
        [TestCase(-100L)]
        [TestCase(1_700_000_000_123_456_700L)]
        public void FromNanoseconds_WholeTicks_RoundTrips(long nanoseconds)
        {
            Assert.That(ControlTime.FromNanoseconds(nanoseconds).Nanoseconds, Is.EqualTo(nanoseconds));
        }

        [TestCase(149L, 100L)]
        [TestCase(150L, 200L)]
        [TestCase(-149L, -100L)]
        [TestCase(-150L, -200L)]
        [TestCase(long.MaxValue, 9223372036854775800L)]
        [TestCase(long.MinValue, -9223372036854775800L)]
        public void FromNanoseconds_BetweenTicks_RoundsToTheNearest(long nanoseconds, long expected)
        {
            Assert.That(ControlTime.FromNanoseconds(nanoseconds).Nanoseconds, Is.EqualTo(expected));
        }

        [Test]
        public void FromSeconds_SubMillisecond_KeepsTheFraction()
        {
            Assert.That(ControlTime.FromSeconds(1.2345678).SinceEpoch.Ticks, Is.EqualTo(12345678));
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(1e12)]
        public void FromSeconds_NotRepresentable_Throws(double seconds)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => ControlTime.FromSeconds(seconds));
        }

        [Test]
        public void Arithmetic_TimePlusDurationMinusTime_IsTheDuration()
        {
            var start = ControlTime.FromSeconds(1.7e9);
            var length = new TimeSpan(1);

            Assert.That(start + length - start, Is.EqualTo(length));
            Assert.That(start + length > start, Is.True);
        }
    }
}
