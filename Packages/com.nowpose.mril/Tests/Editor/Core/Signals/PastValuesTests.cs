using System;
using NUnit.Framework;
using Nowpose.Signals;

namespace Nowpose.Tests.Core.Signals
{
    public class PastValuesTests
    {
        const double MaxGap = 0.5;

        static PastValues<double> New() => new PastValues<double>(MaxGap, (before, after, fraction) => before + fraction * (after - before));

        [TestCase(0.001)]
        [TestCase(0.0073)]
        [TestCase(0.02)]
        [TestCase(0.05)]
        public void TryGet_LastSecond_InterpolatesBetweenNeighbours(double interval)
        {
            var past = New();
            var newest = 0.0;
            for (var k = 0; k * interval < 5; k++) past.Add(newest = k * interval, Math.Sin(k * interval));

            for (var t = newest - 1.2; t < newest; t += 0.0117)
            {
                Assert.That(past.TryGet(t, out var value), Is.True, $"{t} s");
                Assert.That(value, Is.EqualTo(Math.Sin(t)).Within(0.05 * 0.05 / 8 + 1e-9), "h²/8 for an interval h and an acceleration of 1");
            }
            Assert.That(past.TryGet(newest, out var last), Is.True);
            Assert.That(last, Is.EqualTo(Math.Sin(newest)));
        }

        [Test]
        public void TryGet_OutsideTheValuesOrInAGap_ReturnsFalse()
        {
            var past = New();
            Assert.That(past.TryGet(1, out _), Is.False);
            past.Add(1, 10);
            Assert.That((past.TryGet(0.9, out _), past.TryGet(1, out _), past.TryGet(1.1, out _)), Is.EqualTo((false, true, false)));
            past.Add(1 + MaxGap + 0.01, 20);
            Assert.That(past.TryGet(1.2, out _), Is.False, "a gap");
            past.Add(1 + MaxGap + 0.05, 30);
            Assert.That(past.TryGet(1 + MaxGap + 0.03, out var value), Is.True);
            Assert.That(value, Is.EqualTo(25).Within(1e-9));

            past.Clear();
            Assert.That(past.TryGet(1 + MaxGap + 0.05, out _), Is.False);
        }

        [Test]
        public void Add_OlderValue_HasNoEffect()
        {
            var past = New();
            past.Add(1, 10);
            past.Add(1.1, 20);
            past.Add(1.05, 99);
            past.Add(1.1, 99);

            Assert.That(past.TryGet(1.05, out var value), Is.True);
            Assert.That(value, Is.EqualTo(15).Within(1e-9));
        }
    }
}
