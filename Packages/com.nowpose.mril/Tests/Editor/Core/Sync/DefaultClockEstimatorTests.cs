using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>
    /// Compares the default estimator with the paper's estimator on the same exchanges. The constants were chosen with other seeds.
    /// </summary>
    public class DefaultClockEstimatorTests
    {
        const int FirstSeed = 100, Seeds = 4;

        static SimulatedLink Link(string network, int seed, double loss = 0, bool isLoaded = false)
        {
            var skewPpm = (seed % 2 == 0 ? 1 : -1) * (5 + 25 * (seed % 4));
            var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm, skewVariationPpm: 2, loss, skewPeriod: 300 + 100 * (seed % 4));
            if (isLoaded) link.Load = SimulatedLink.Queues;
            return link;
        }

        static SyncRun Run(string estimator, SimulatedLink link, double seconds)
        {
            var run = new SyncRun(ClockEstimators.Create(estimator));
            run.Run(link, 0, seconds);
            return run;
        }

        [Category("Study")]
        [TestCase("lan", 0, 0.03, 0.5)]
        [TestCase("wifi", 0, 0.05, 0.25)]
        [TestCase("busy-wifi", 0.02, 0.12, 0.15)]
        public void Error_AfterTenSeconds_IsAFractionOfTheErrorOfThePapersEstimator(string network, double loss, double limitMs, double share)
        {
            double ours = 0, papers = 0;
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                ours += Run("default", Link(network, seed, loss), 300).PercentileMs(10, 0.95) / Seeds;
                papers += Run("ransac", Link(network, seed, loss), 300).PercentileMs(10, 0.95) / Seeds;
            }

            Assert.That(ours, Is.LessThan(limitMs), "on average; seeds from " + FirstSeed);
            Assert.That(ours, Is.LessThan(share * papers), "on average; seeds from " + FirstSeed);
        }

        [Category("Study")]
        [Test]
        public void Error_BusyWifiUnderLoad_IsSmallAfterAMinute()
        {
            var errors = Enumerable.Range(FirstSeed, Seeds)
                .Select(seed => Run("default", Link("busy-wifi", seed, 0.02, isLoaded: true), 300).PercentileMs(60, 0.95)).ToArray();

            Assert.That(errors.Average(), Is.LessThan(0.15), "seeds from " + FirstSeed);
        }

        [TestCase("wifi", 0, 2, 10)]
        [TestCase("busy-wifi", 0.02, 5, 30)]
        public void Error_FromTheStart_FallsBelowTheLimitsInTime(string network, double loss, double secondsTo1Ms, double secondsTo200Us)
        {
            for (var seed = FirstSeed; seed < FirstSeed + 2 * Seeds; seed++)
            {
                var run = Run("default", Link(network, seed, loss), 60);

                Assert.That(run.ErrorsMs(secondsTo1Ms).Max(), Is.LessThan(1), "seed " + seed);
                Assert.That(run.PercentileMs(secondsTo200Us, 0.95), Is.LessThan(0.2), "seed " + seed);
            }
        }

        [Category("Study")]
        [TestCase("wifi", 0, 0.1)]
        [TestCase("busy-wifi", 0.02, 0.2)]
        public void Error_NoExchangesForThirtySeconds_StaysSmall(string network, double loss, double limitMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link(network, seed, loss);
                var run = Run("default", link, 180);
                run.Run(link, 180, 210, exchange: false);

                Assert.That(run.ErrorsMs(180).Max(), Is.LessThan(limitMs), "seed " + seed);
                Assert.That(run.Instants.Last().Model.ErrorBound.TotalMilliseconds, Is.LessThan(4), "the skew is estimated; seed " + seed);
            }
        }

        [TestCase(-1.7e9)]
        [TestCase(0)]
        [TestCase(4e9)]
        public void Error_DistantEpochs_StaysSmall(double epoch)
        {
            var link = new SimulatedLink(NetworkProfile.Lan, FirstSeed, 40, controlEpoch: epoch);

            Assert.That(Run("default", link, 60).PercentileMs(10, 1), Is.LessThan(0.02));
        }

        [Test]
        public void Error_ControlClockFlooredToItsCycle_IsUnbiased()
        {
            // The exchanges are 200 cycles apart. With a skew of 80 ppm, their position in the cycle moves by only 16 µs from one exchange
            // to the next.
            var link = Link("lan", FirstSeed + 3);
            link.Resolution = TimeSpan.FromMilliseconds(1);

            Assert.That(Run("default", link, 120).PercentileMs(20, 0.95), Is.LessThan(0.15), "half a cycle would be 0.5 ms");
        }

        [Test]
        public void Error_ChangingExchangeInterval_StaysSmall()
        {
            var link = Link("wifi", FirstSeed);
            var run = new SyncRun(new DefaultClockEstimator());
            run.Run(link, 0, 5, intervalSeconds: 0.05);
            run.Run(link, 5, 60);
            run.Run(link, 60, 240, intervalSeconds: 1);
            run.Run(link, 240, 300);

            Assert.That(run.PercentileMs(5, 0.95), Is.LessThan(0.08));
        }

        [Test]
        public void Skew_SymmetricPathWithoutJitter_IsExact()
        {
            const double skewPpm = 50;
            var estimator = new DefaultClockEstimator();
            for (var i = 0; i < 600; i++)
            {
                var t1 = HeadsetTime.FromSeconds(1e5 + i * 0.2);
                var middle = t1 + TimeSpan.FromMilliseconds(2);
                var offset = new ClockOffset(Lengths.Seconds(-1.7e9) + TimeSpan.FromTicks((long)Math.Round(i * 0.2e7 * skewPpm * 1e-6)));
                estimator.Add(new SyncExchange(t1, offset.ToControl(middle), offset.ToControl(middle), t1 + TimeSpan.FromMilliseconds(4)));
            }

            Assert.That(estimator.Line.Skew * 1e6, Is.EqualTo(skewPpm).Within(0.05));
        }

        [Category("Study")]
        [TestCase("lan")]
        [TestCase("wifi")]
        [TestCase("busy-wifi")]
        public void OffsetError_OnceSynchronised_IsAStandardError(string network)
        {
            var link = Link(network, FirstSeed + 1);
            var run = Run("default", link, 10);
            int within = 0, all = 0;
            for (; all < 190; all++)
            {
                run.Run(link, 10 + all, 11 + all);
                if (Math.Abs(run.Instants.Last().ErrorMs) < 2 * run.Clock.OffsetError.TotalMilliseconds) within++;
            }

            Assert.That(within / (double)all, Is.GreaterThan(0.85), "0.95 if the errors of successive seconds were independent");
        }

        [Test]
        public void Line_AfterRestart_IsEmptyAndStartsWithTheEarlierSkew()
        {
            var estimator = new DefaultClockEstimator();
            var link = Link("lan", FirstSeed + 3);
            for (var i = 0; i < 500; i++)
                if (link.TryExchange(HeadsetTime.FromSeconds(i * 0.2), out var exchange)) estimator.Add(exchange);
            var skew = estimator.Line.Skew;

            estimator.Restart(1e-6);

            Assert.That(estimator.Line.Exchanges, Is.EqualTo(0));
            link.TryExchange(HeadsetTime.FromSeconds(101), out var first);
            estimator.Add(first);
            Assert.That(estimator.Line.Skew, Is.EqualTo(skew).Within(1e-9));
        }
    }
}
