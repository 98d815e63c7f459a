using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>
    /// Tests the detection of control clock steps with the default estimator, and events that must not be counted as steps.
    /// </summary>
    [Category("Study")]
    public class ClockStepTests
    {
        const int FirstSeed = 200, Seeds = 4;

        static SimulatedLink Link(string network, int seed, bool isLoaded = false)
        {
            var link = new SimulatedLink(
                NetworkProfile.Named(network), seed, skewPpm: 60 - 30 * (seed % 4), skewVariationPpm: 2, lossChance: isLoaded ? 0.02 : 0, skewPeriod: 400);
            if (isLoaded) link.Load = SimulatedLink.Queues;
            return link;
        }

        [TestCase("wifi", 50, 2)]
        [TestCase("wifi", -50, 2)]
        [TestCase("wifi", 2, 5)]
        [TestCase("wifi", -2, 5)]
        [TestCase("busy-wifi", 50, 2)]
        [TestCase("lan", 0.5, 4)]
        [TestCase("lan", -0.5, 4)]
        public void Step_OfTheControlClock_IsDetectedOnceWithinTheLimit(string network, double stepMs, double limitSeconds)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link(network, seed);
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 90);
                link.Step = Lengths.Ms(stepMs);
                run.Run(link, 90, 90 + limitSeconds);

                Assert.That(run.Clock.Steps, Is.EqualTo(1), "seed " + seed);

                run.Run(link, 90 + limitSeconds, 110);

                Assert.That(run.Clock.Steps, Is.EqualTo(1), "the step is counted only once; seed " + seed);
                Assert.That(run.PercentileMs(100, 0.95), Is.LessThan(network == "busy-wifi" ? 0.8 : 0.2),
                    "the estimator restarts with the earlier skew; seed " + seed);
            }
        }

        // The step occurs at the start of a load, under which most exchanges have such long round-trip times that they allow for the step.
        [Test]
        public void Step_HiddenByMostRoundTripTimes_IsDetectedWithinSixSecondsAndBounded()
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link("busy-wifi", seed, isLoaded: true);
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 120);
                link.Step = Lengths.Ms(seed % 2 == 0 ? 10 : -10);
                run.Run(link, 120, 126);

                Assert.That(run.Clock.Steps, Is.EqualTo(1), "seed " + seed);
                var isOutside = run.Instants.Where(i => i.At > 120).Select(i => Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds);
                Assert.That(isOutside.SkipWhile(outside => outside), Has.None.True, "from the first contradiction on; seed " + seed);
            }
        }

        [Test]
        public void Step_ExchangesWithLongIntervals_IsDetectedByTheThird()
        {
            var link = Link("lan", FirstSeed);
            var run = new SyncRun(new DefaultClockEstimator());
            run.Run(link, 0, 90);
            link.Step = Lengths.Ms(20);
            run.Run(link, 90, 90 + 3 * 12, intervalSeconds: 12);

            Assert.That(run.Clock.Steps, Is.EqualTo(1), "seed " + FirstSeed);
        }

        [Test]
        public void Step_HalfAMillisecondOverWifi_IsUsuallyDetectedWithinSixSeconds()
        {
            var found = 0;
            for (var seed = FirstSeed; seed < FirstSeed + 20; seed++)
            {
                var link = Link("wifi", seed);
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 90);
                link.Step = Lengths.Ms(seed % 2 == 0 ? 0.5 : -0.5);
                run.Run(link, 90, 96);
                if (run.Clock.Steps == 1) found++;
            }

            Assert.That(found, Is.GreaterThanOrEqualTo(12), "of 20, seeds from " + FirstSeed);
        }

        [Test]
        public void ErrorBound_SmallStep_IsViolatedForLessThanASecond()
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link("wifi", seed);
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 90);
                link.Step = TimeSpan.FromMilliseconds(2);
                run.Run(link, 90, 95);

                var broken = run.Instants.Count(i => i.At > 90 && Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds) * 0.02;
                Assert.That(broken, Is.LessThan(1), "seconds; seed " + seed);
            }
        }

        [TestCase("wifi", false)]
        [TestCase("busy-wifi", true)]
        public void Steps_HourWithoutAStep_AreZeroAndTheBoundHolds(string network, bool isLoaded)
        {
            var run = new SyncRun(new DefaultClockEstimator());

            run.Run(Link(network, FirstSeed, isLoaded), 0, 3600);

            Assert.That(run.Clock.Steps, Is.EqualTo(0), "seed " + FirstSeed);
            Assert.That(run.Instants.Count(i => i.Model.IsKnown && Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds), Is.EqualTo(0));
        }

        [TestCase("lan", 4)]
        [TestCase("lan", -0.1)]
        [TestCase("wifi", 4)]
        [TestCase("wifi", -1)]
        public void Steps_DelayOfOneDirectionChanges_AreZero(string network, double upMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link(network, seed);
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 60);
                link.LongerUpMs = upMs;
                run.Run(link, 60, 120);

                Assert.That(run.Clock.Steps, Is.EqualTo(0), "seed " + seed);
                var outside = run.Instants.Where(i => i.At > 61).Select(i => (i.At, Math.Abs(i.ErrorMs) - i.Model.ErrorBound.TotalMilliseconds))
                    .Where(i => i.Item2 > 0).ToArray();
                Assert.That(outside, Is.Empty, "seed " + seed);
            }
        }

        /// <summary>
        /// Both bounds of the offset move in the same direction, as after a clock step, but by different amounts. The minimum round-trip time
        /// therefore changes, unlike after a step.
        /// </summary>
        [Test]
        public void Steps_OneWayDelaysChangeOppositelyByDifferentAmounts_AreZero(
            [Values("lan", "wifi", "busy-wifi")] string network, [Values(4.0, 1.0)] double longer, [Values(true, false)] bool isUpLonger)
        {
            var shorter = 5 - longer;
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link(network, seed);
                if (isUpLonger) link.LongerDownMs = shorter;
                else link.LongerUpMs = shorter;
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 90);
                (link.LongerUpMs, link.LongerDownMs) = isUpLonger ? (longer, 0.0) : (0.0, longer);
                run.Run(link, 90, 120);

                Assert.That(run.Clock.Steps, Is.EqualTo(0), "seed " + seed);
                var outside = run.Instants.Where(i => i.At > 95 && Math.Abs(i.ErrorMs) > i.Model.EstimatedError.TotalMilliseconds).ToArray();
                Assert.That(outside.Select(i => (i.At, i.ErrorMs, i.Model.EstimatedError)), Is.Empty, "seed " + seed);
            }
        }

        /// <summary>The exchanges are the same as after a clock step of 4 ms, so this change counts as a step.</summary>
        [Test]
        public void Steps_OneWayDelaysChangeByOppositeAmounts_IncreaseByOne()
        {
            var link = Link("wifi", FirstSeed);
            link.LongerDownMs = 4;
            var run = new SyncRun(new DefaultClockEstimator());
            run.Run(link, 0, 90);
            (link.LongerUpMs, link.LongerDownMs) = (4, 0);
            run.Run(link, 90, 120);

            Assert.That(run.Clock.Steps, Is.EqualTo(1), "seed " + FirstSeed);
        }

        [TestCase(300)]
        [TestCase(-600)]
        public void Steps_ClockOfAnotherMachineIsServed_IncreaseByOne(double skewPpm)
        {
            foreach (var network in NetworkProfile.All)
            {
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(Link(network.Name, FirstSeed), 0, 60);
                // The clock of the other machine also has another epoch.
                run.Run(new SimulatedLink(network, FirstSeed + 1, skewPpm, controlEpoch: 5000), 60, 180);

                Assert.That(run.Clock.Steps, Is.EqualTo(1), network.Name);
                Assert.That(run.PercentileMs(150, 1), Is.LessThan(0.8), network.Name);
            }
        }
    }
}
