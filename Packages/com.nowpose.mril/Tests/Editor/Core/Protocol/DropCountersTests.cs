using System.Threading;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Protocol
{
    public class DropCountersTests
    {
        [Test]
        public void Count_FromManyThreads_CountsAll()
        {
            var counters = new DropCounters();
            var threads = new Thread[4];
            for (var i = 0; i < threads.Length; i++)
                threads[i] = new Thread(() => CountMany(counters));

            foreach (var thread in threads) thread.Start();
            foreach (var thread in threads) thread.Join();

            Assert.That(counters[DropReason.NotJson], Is.EqualTo(40_000));
            Assert.That(counters.Total, Is.EqualTo(80_000));
        }

        [Test]
        public void Snapshot_SomeReasonsCounted_ContainsOnlyTheCountedReasons()
        {
            var counters = new DropCounters();
            counters.Count(DropReason.TooDeep);
            counters.Count(DropReason.None);

            var snapshot = counters.Snapshot();

            Assert.That(snapshot.Count, Is.EqualTo(1));
            Assert.That(snapshot[0].Key, Is.EqualTo(DropReason.TooDeep));
            Assert.That(snapshot[0].Value, Is.EqualTo(1));
        }

        static void CountMany(DropCounters counters)
        {
            for (var i = 0; i < 10_000; i++)
            {
                counters.Count(DropReason.NotJson);
                counters.Count(DropReason.Unsynchronised);
            }
        }
    }
}
