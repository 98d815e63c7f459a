using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Samples
{
    public class SampleBufferTests
    {
        const double MaximumGap = 0.5;

        // Uses the samples as they are.
        static SampleBuffer<JointSample> Buffer(int capacity) =>
            new SampleBuffer<JointSample>(capacity, PredictionLimits.Unlimited);

        [TestCase(1)]
        [TestCase(5)]
        [TestCase(24)]
        public void Add_SamplesInAnyOrder_KeepsTheNewestSorted(int capacity)
        {
            var (buffer, random, all) = (Buffer(capacity), new Random(capacity), new List<double>());
            for (var i = 0; i < 300; i++)
            {
                // Most samples are newer than all others; some are late, some are repeated.
                var time = random.Next(4) > 0 || i == 0 ? i : Math.Max(0, i - random.Next(2 * capacity));
                var isKnown = all.Contains(time) || (all.Count >= capacity && time < all[capacity - 1]);
                Assert.That(buffer.Add(new JointSample(time, -time), displayed: double.NaN), Is.EqualTo(!isKnown), "sample " + i);
                if (!isKnown) all.Add(time);
                all.Sort((a, b) => b.CompareTo(a));
                if (all.Count > capacity) all.RemoveAt(capacity);

                Assert.That(Enumerable.Range(0, buffer.Count).Select(age => buffer[age].Time), Is.EqualTo(all), "sample " + i);
                Assert.That(buffer[0].Position, Is.EqualTo(-all[0]));
                Assert.That(buffer.OldestOrder, Is.EqualTo(all.Count < capacity ? double.NegativeInfinity : all[capacity - 1]));
            }
        }

        [Test]
        public void CountWithoutGap_GapsAndLateSamples_CountsTheNewestWithoutGap()
        {
            var (buffer, random, time) = (Buffer(8), new Random(3), 0.0);
            for (var i = 0; i < 300; i++)
            {
                var isNewest = i == 0 || random.Next(5) > 0;
                if (isNewest) time += random.Next(4) > 0 ? 0.1 : 0.9;
                buffer.Add(new JointSample(isNewest ? time : time - random.NextDouble(), 0), displayed: double.NaN);

                var gaps = Enumerable.Range(1, buffer.Count).Where(age => age == buffer.Count || buffer[age - 1].Time - buffer[age].Time > MaximumGap);
                Assert.That(buffer.CountWithoutGap(MaximumGap), Is.EqualTo(gaps.First()), "sample " + i);
            }
        }

        [TestCase(0.010, 100)]
        [TestCase(0.050, 100)]
        [TestCase(0.002, 34)]
        public void Add_FastSource_ThinsTheHistory(double interval, int expected)
        {
            var buffer = new SampleBuffer<JointSample>(200, PredictionLimits.Unlimited, thins: true);
            var changes = 0;
            for (var k = 0; k < 100; k++)
            {
                if (buffer.Add(new JointSample(k * interval, k), displayed: double.NaN)) changes++;
            }

            Assert.That(buffer.Count, Is.EqualTo(expected).And.EqualTo(changes));
            Assert.That(buffer.Newest.Position, Is.EqualTo(99));
            Assert.That(buffer.NewestStamp, Is.EqualTo(99 * interval));
        }

        // Every fourth sample overtakes the three before it.
        [Test]
        public void Add_OvertakenSamplesOfAFastSource_ThinsThemToo()
        {
            var buffer = new SampleBuffer<JointSample>(24, PredictionLimits.Unlimited, thins: true);
            for (var k = 0; k < 100; k += 4)
                foreach (var i in new[] { 3, 0, 1, 2 }) buffer.Add(new JointSample((k + i) * 0.001, k + i), displayed: double.NaN);

            for (var age = 1; age < buffer.Count; age++)
                Assert.That(buffer[age - 1].Time - buffer[age].Time, Is.GreaterThanOrEqualTo(0.0055), "sample " + age);
            Assert.That(buffer.Count, Is.GreaterThan(10));
        }

        // Scatter alone can make a corrected stamp older than the previous one, so the newest sample keeps its own stamp.
        [Test]
        public void Add_ScatteredStamps_KeepsTheNewestUnchanged()
        {
            var random = new Random(21);
            var buffer = new SampleBuffer<JointSample>(24, PredictionLimits.Unlimited, new StampCorrection(1), thins: true);
            for (var k = 0; k < 300; k++)
            {
                var stamp = k * 0.05 + 0.01 * (2 * random.NextDouble() - 1);
                buffer.Add(new JointSample(stamp, Math.Sin(k), k * 0.05), displayed: double.NaN);
                Assert.That((buffer.NewestStamp, buffer.Newest.Position), Is.EqualTo((stamp, Math.Sin(k))), "seed 21");
            }

            buffer.Add(new JointSample(298.5 * 0.05, 5, 298.5 * 0.05), displayed: double.NaN);
            Assert.That(buffer.Newest.Position, Is.EqualTo(Math.Sin(299)), "overtaken");
        }

        [TestCase(0.001)]
        [TestCase(0.002)]
        [TestCase(0.004)]
        public void Adaptive_FastSource_IsMoreAccurateThanLinear(double interval)
        {
            var random = new Random(8);
            var adaptive = new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited));
            var linear = new DisplayedJoint(Predictors.Create("linear", PredictionLimits.Unlimited));
            double squares = 0, squaresOfLinear = 0;
            for (var k = 0; k * interval < 20; k++)
            {
                var t = k * interval;
                var sample = new JointSample(t, Motion(t) + 1e-5 * (random.NextDouble() - 0.5));
                adaptive.Add(sample);
                linear.Add(sample);
                if (k % 16 != 0) continue;
                var (a, l) = (adaptive.Show(t + 0.1).Position, linear.Show(t + 0.1).Position);
                if (t < 5) continue;
                squares += Math.Pow(a - Motion(t + 0.1), 2);
                squaresOfLinear += Math.Pow(l - Motion(t + 0.1), 2);
            }

            Assert.That(squares, Is.LessThan(0.6 * squaresOfLinear), "seed 8");
        }

        static double Motion(double t) => Math.Sin(2 * t) + 0.4 * Math.Sin(5.1 * t + 1);
    }
}
