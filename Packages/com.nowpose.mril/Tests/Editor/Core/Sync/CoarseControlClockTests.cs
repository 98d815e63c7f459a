using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>Tests control clocks that advance in steps of a millisecond or of a PLC's cycle and report this resolution.</summary>
    /// <remarks>The constants of the estimator were chosen with other simulated delays, whose seeds are 1 to 88.</remarks>
    [Category("Study")]
    public class CoarseControlClockTests
    {
        static readonly double[] Resolutions = { 1, 4, 8, 10, 15.6 };
        static readonly double[] Skews = { -80, 0, 12, 200 };

        [Test, Combinatorial]
        public void ErrorBound_ExchangesAtThePaceOfTheHeadset_HoldsWithoutAClockStep(
            [ValueSource(nameof(Resolutions))] double resolutionMs, [ValueSource(nameof(Skews))] double skewPpm, [Values(0, 1.2)] double latestMs)
        {
            var seed = 600 + (int)skewPpm;
            var link = new SimulatedLink(NetworkProfile.Lan, seed, skewPpm) { Resolution = Lengths.Ms(resolutionMs) };
            var run = new PacedRun(seed: seed, latestMs: latestMs);

            run.Run(link, 120);

            Assert.That(run.Errors.Count(e => Math.Abs(e.ErrorMs) > e.BoundMs), Is.EqualTo(0), "seed " + seed);
            Assert.That(run.Clock.Steps, Is.EqualTo(0), "no clock stepped; seed " + seed);
            // A single exchange is accurate to half the resolution; many exchanges together are accurate to a tenth of the resolution. With
            // a skew of four times the expected one, reaching this accuracy takes half a minute.
            Assert.That(run.P95Ms(30), Is.LessThan(0.1 * resolutionMs), "seed " + seed);
        }

        [Test, Combinatorial]
        public void ErrorBound_ExchangesAtTheSamePhaseOfTheCycle_HoldsWithoutAClockStep(
            [ValueSource(nameof(Resolutions))] double resolutionMs, [ValueSource(nameof(Skews))] double skewPpm,
            [Values("lan", "wifi")] string network)
        {
            var seed = 700 + (int)skewPpm;
            var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm) { Resolution = Lengths.Ms(resolutionMs) };
            var run = new SyncRun(new DefaultClockEstimator());

            run.Run(link, 0, 120);

            var known = run.Instants.Where(i => i.Model.IsKnown);
            Assert.That(known.Count(i => Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds), Is.EqualTo(0), "seed " + seed);
            Assert.That(run.Clock.Steps, Is.EqualTo(0), "no clock stepped; seed " + seed);
        }

        /// <summary>
        /// Such exchanges have a common error of up to half a step, which changes by a step when they reach the next one. Nothing else is wrong.
        /// </summary>
        [Test, Combinatorial]
        public void EstimatedError_ExchangesAtTheSamePhaseOfTheCycle_HoldsAndAllExchangesAreKept(
            [Values(4, 10)] double resolutionMs, [Values(-50, 20, 50)] double skewPpm)
        {
            const int Seconds = 900, ExchangesPerSecond = 5;
            var seed = 900 + (int)skewPpm;
            var link = new SimulatedLink(NetworkProfile.Lan, seed, skewPpm) { Resolution = Lengths.Ms(resolutionMs) };
            var run = new SyncRun(new DefaultClockEstimator());

            run.Run(link, 0, Seconds);

            var later = run.Instants.Where(i => i.At >= 20).ToArray();
            Assert.That(
                later.Average(i => Math.Abs(i.ErrorMs) <= i.Model.EstimatedError.TotalMilliseconds ? 1 : 0), Is.GreaterThan(0.999), "seed " + seed);
            Assert.That(run.Clock.Exchanges, Is.EqualTo(Seconds * ExchangesPerSecond).Within(1), "seed " + seed);
        }

        [TestCase(1, 5)]
        [TestCase(4, 20)]
        [TestCase(10, -50)]
        public void Step_OfACoarseControlClock_IsDetected(double resolutionMs, double stepMs)
        {
            var link = new SimulatedLink(NetworkProfile.Lan, 800, 20) { Resolution = Lengths.Ms(resolutionMs) };
            var run = new PacedRun();
            run.Run(link, 60);

            link.Step = Lengths.Ms(stepMs);
            run.Run(link, 63);

            Assert.That(run.Clock.Steps, Is.EqualTo(1), "seed 800");
        }

        /// <summary>
        /// The resolution changes because the gateway serves another clock, or because a simulation changes the length of its cycle.
        /// </summary>
        [Test, Combinatorial]
        public void ErrorBound_ResolutionChanges_HoldsWithoutAClockStep(
            [Values(0, 1, 10, 50)] double beforeMs, [Values(0, 1, 10, 50)] double afterMs, [Values("lan", "wifi")] string network)
        {
            var link = new SimulatedLink(NetworkProfile.Named(network), 810, 20) { Resolution = Lengths.Ms(beforeMs) };
            var run = new PacedRun(seed: 810);
            run.Run(link, 60);

            link.Resolution = Lengths.Ms(afterMs);
            run.Run(link, 150);

            Assert.That(run.Errors.Where(e => Math.Abs(e.ErrorMs) > e.BoundMs).Select(e => (e.At, e.ErrorMs)), Is.Empty);
            Assert.That(run.Clock.Steps, Is.EqualTo(0), "no clock stepped");
            Assert.That(run.P95Ms(110), Is.LessThan(0.2 + 0.1 * afterMs));
            Assert.That(run.P95Ms(60), Is.LessThan(Math.Max(beforeMs, afterMs) / 2 + 1),
                "during the change, the error is at most half the coarser resolution plus 1 ms");
        }

        /// <summary>A server that estimates the resolution of its clock may overstate it for a short time.</summary>
        [TestCase("lan", 0.1)]
        [TestCase("wifi", 0.1)]
        [TestCase("lan", 3)]
        [TestCase("wifi", 3)]
        public void ErrorBound_ResolutionOverstatedForAWhile_HoldsWithoutAClockStep(string network, double seconds)
        {
            for (var seed = 820; seed < 824; seed++)
            {
                var link = new SimulatedLink(NetworkProfile.Named(network), seed, 20) { Resolution = Lengths.Ms(10) };
                var run = new PacedRun(seed: seed);
                run.Run(link, 60);

                link.StatedResolution = Lengths.Ms(50);
                run.Run(link, 60 + seconds);
                link.StatedResolution = null;
                run.Run(link, 150);

                Assert.That(run.Errors.Where(e => Math.Abs(e.ErrorMs) > e.BoundMs).Select(e => (e.At, e.ErrorMs)), Is.Empty, "seed " + seed);
                Assert.That(run.P95Ms(61 + seconds), Is.LessThan(2), "seed " + seed);
                Assert.That(run.Clock.Steps, Is.EqualTo(0), "no clock stepped; seed " + seed);
            }
        }

        [TestCase(10, 1, 100)]
        [TestCase(1, 10, -100)]
        [TestCase(50, 0, 1000)]
        public void Step_WithAChangeOfResolution_IsDetected(double beforeMs, double afterMs, double stepMs)
        {
            var link = new SimulatedLink(NetworkProfile.Wifi, 830, 20) { Resolution = Lengths.Ms(beforeMs) };
            var run = new PacedRun();
            run.Run(link, 60);

            link.Resolution = Lengths.Ms(afterMs);
            link.Step = Lengths.Ms(stepMs);
            run.Run(link, 64);

            Assert.That(run.Clock.Steps, Is.EqualTo(1));
        }
    }
}
