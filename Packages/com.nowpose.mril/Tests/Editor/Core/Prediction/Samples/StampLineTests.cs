using System;
using Nowpose.Prediction.Samples;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Samples
{
    public class StampLineTests
    {
        const int Seed = 31;

        readonly StampLine _line = new StampLine();
        readonly Random _random = new Random(Seed);

        // The sums are updated with a forgetting factor and must not accumulate rounding errors: a day at 10 Hz, three hours at 100 Hz.
        [TestCase(0.1, 900_000)]
        [TestCase(0.01, 1_000_000)]
        [TestCase(1 / 30.0, 300_000)]
        public void Add_ExactStampsForHours_LineIsExact(double interval, int stamps)
        {
            const double epoch = 123.456;
            for (var k = 0; k < stamps; k++) _line.Add(epoch + k * interval);

            Assert.That(_line.NewestOnLine, Is.EqualTo(epoch + (stamps - 1) * interval).Within(1e-9));
            Assert.That(_line.Interval, Is.EqualTo(interval).Within(1e-12));
            Assert.That(_line.Deviation, Is.LessThan(1e-9));
        }

        [TestCase(0.05, 0)]
        [TestCase(0.02, 0.05)]
        public void Add_ScatteredAndLostStamps_EstimatesThePeriod(double interval, double loss)
        {
            var (last, squares, count) = (0.0, 0.0, 0);
            for (var k = 0; k < 20_000; k++)
            {
                if (_random.NextDouble() < loss) continue;
                last = k * interval;
                _line.Add(last + 0.2 * interval * (2 * _random.NextDouble() - 1));
                if (k < 200) continue;
                squares += Math.Pow(_line.NewestOnLine - last, 2);
                count++;
            }

            // The error at the end of a line through n stamps is twice their scatter divided by √n; a forgetting factor of 0.99 gives n = 125.
            Assert.That(Math.Sqrt(squares / count), Is.LessThan(1.2 * 2 / Math.Sqrt(125) * 0.2 * interval / Math.Sqrt(3)), "seed " + Seed);
            Assert.That(_line.Interval, Is.EqualTo(interval).Within(1e-3 * interval), "seed " + Seed);
            Assert.That(_line.Deviation, Is.EqualTo(0.2 * interval / Math.Sqrt(3)).Within(0.2 * 0.2 * interval / Math.Sqrt(3)), "seed " + Seed);
        }

        [Test]
        public void Add_IntervalDrifts_IsFollowed()
        {
            var (time, interval) = (0.0, 0.0500333);
            for (var k = 0; k < 20_000; k++)
            {
                interval *= 1 + 1e-8;
                _line.Add(time += interval);
            }

            // With a forgetting factor of 0.99, the line lags behind a drift of 0.5 ns per stamp by the drift times 100².
            Assert.That(_line.NewestOnLine, Is.EqualTo(time).Within(1e-5));
            Assert.That(_line.Interval, Is.EqualTo(interval).Within(2e-7));
        }

        [Test]
        public void Add_IntervalChanges_NewIntervalIsEstimated()
        {
            for (var k = 0; k < 200; k++) _line.Add(k * 0.05);
            for (var k = 0; k < 150; k++) _line.Add(10 + k * 0.035);

            Assert.That(_line.IsKnown);
            Assert.That(_line.Interval, Is.EqualTo(0.035).Within(1e-3));
        }

        [Test]
        public void Add_LongPause_LineIsUnknown()
        {
            for (var k = 0; k < 200; k++) _line.Add(k * 0.05);

            _line.Add(200 * 0.05 + 3);

            Assert.That(_line.IsKnown, Is.False);
        }
    }
}
