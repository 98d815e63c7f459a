using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Samples
{
    public class SampleHistoryTests
    {
        const double MaximumGap = 0.5;

        [TestCase(1)]
        [TestCase(5)]
        [TestCase(24)]
        public void Add_SamplesInAnyOrder_KeepsTheNewestSorted(int capacity)
        {
            var (history, random, all) = (new SampleHistory<JointSample>(capacity), new Random(capacity), new List<double>());
            for (var i = 0; i < 300; i++)
            {
                // Most samples are newer than all others; some are late, some are repeated.
                var time = random.Next(4) > 0 || i == 0 ? i : Math.Max(0, i - random.Next(2 * capacity));
                var isKnown = all.Contains(time) || (all.Count >= capacity && time < all[capacity - 1]);
                Assert.That(history.Add(new JointSample(time, -time)), Is.EqualTo(!isKnown), "sample " + i);
                if (!isKnown) all.Add(time);
                all.Sort((a, b) => b.CompareTo(a));
                if (all.Count > capacity) all.RemoveAt(capacity);

                Assert.That(Enumerable.Range(0, history.Count).Select(age => history[age].Time), Is.EqualTo(all), "sample " + i);
                Assert.That(history[0].Position, Is.EqualTo(-all[0]));
                Assert.That(history.OldestOrder, Is.EqualTo(all.Count < capacity ? double.NegativeInfinity : all[capacity - 1]));
            }
        }

        [Test]
        public void CountWithoutGap_GapsAndLateSamples_CountsTheNewestWithoutGap()
        {
            var (history, random, time) = (new SampleHistory<JointSample>(8), new Random(3), 0.0);
            for (var i = 0; i < 300; i++)
            {
                var isNewest = i == 0 || random.Next(5) > 0;
                if (isNewest) time += random.Next(4) > 0 ? 0.1 : 0.9;
                history.Add(new JointSample(isNewest ? time : time - random.NextDouble(), 0));

                var gaps = Enumerable.Range(1, history.Count).Where(age => age == history.Count || history[age - 1].Time - history[age].Time > MaximumGap);
                Assert.That(history.CountWithoutGap(MaximumGap), Is.EqualTo(gaps.First()), "sample " + i);
            }
        }
    }
}
