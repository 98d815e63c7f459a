using System;
using System.Linq;
using Nowpose.Network;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class BackoffTests
    {
        static readonly double[] Expected = { 0.2, 0.4, 0.8, 1.5, 1.5, 1.5 };

        [Test]
        public void Next_RepeatedFailures_DoublesUpToTheMaximumWithin20Percent()
        {
            for (var seed = 0; seed < 50; seed++)
            {
                var backoff = new Backoff(new Random(seed));
                foreach (var seconds in Expected)
                    Assert.That(backoff.Next().TotalSeconds, Is.InRange(0.8 * seconds, 1.2 * seconds), "seed " + seed);
            }
        }

        [Test]
        public void Next_DifferentSeeds_VariesTheDelay()
        {
            var waits = Enumerable.Range(0, 200).Select(seed => new Backoff(new Random(seed)).Next().TotalSeconds).ToList();

            Assert.That(waits.Min(), Is.LessThan(0.17));
            Assert.That(waits.Max(), Is.GreaterThan(0.23));
        }

        [TestCase(10, 0.16, 0.24)]
        [TestCase(9.9, 1.2, 1.8)]
        [TestCase(0, 1.2, 1.8)]
        public void ResetAfter_Failures_StartsWithTheMinimumOnlyAfterALongConnection(double connectedSeconds, double min, double max)
        {
            var backoff = new Backoff(new Random(1));
            for (var i = 0; i < 5; i++) backoff.Next();

            backoff.ResetAfter(Lengths.Seconds(connectedSeconds));

            Assert.That(backoff.Next().TotalSeconds, Is.InRange(min, max));
        }
    }
}
