using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests
{
    /// <summary>Control clocks that advance in steps of a millisecond or of a PLC's cycle, and say so.</summary>
    /// <remarks>The constants were chosen on other delays, with seeds 1 to 88.</remarks>
    public class CoarseControlClockTests
    {
        static readonly double[] Resolutions = { 1, 4, 8, 10, 15.6 };
        static readonly double[] Skews = { -80, -24, 0, 12, 30, 200 };

        [Test, Combinatorial]
        public void ErrorBound_AtTheClientsPace_HoldsAndIsNoStep(
            [ValueSource(nameof(Resolutions))] double resolutionMs, [ValueSource(nameof(Skews))] double skewPpm, [Values(0, 1.2)] double latestMs)
        {
            var seed = 600 + (int)skewPpm;
            var link = new SimulatedLink(NetworkProfile.Lan, seed, skewPpm) { Resolution = Lengths.Ms(resolutionMs) };
            var run = new PacedRun(seed: seed, latestMs: latestMs);

            run.Run(link, 120);

            Assert.That(run.Errors.Count(e => Math.Abs(e.ErrorMs) > e.BoundMs), Is.EqualTo(0), "seed " + seed);
            Assert.That(run.Clock.Steps, Is.EqualTo(0), "no clock stepped; seed " + seed);
            // One exchange tells half a step, many together a tenth: within half a minute, where the skew is four times what is expected.
            Assert.That(run.P95Ms(30), Is.LessThan(0.1 * resolutionMs), "seed " + seed);
        }

        [Test, Combinatorial]
        public void ErrorBound_ExchangesThatMeetOnePartOfTheStep_HoldsAndIsNoStep(
            [ValueSource(nameof(Resolutions))] double resolutionMs, [ValueSource(nameof(Skews))] double skewPpm,
            [Values("lan", "wifi")] string network)
        {
            var seed = 700 + (int)skewPpm;
            var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm) { Resolution = Lengths.Ms(resolutionMs) };
            var run = new SyncRun(new EnvelopeClockEstimator());

            run.Run(link, 0, 120);

            var known = run.Instants.Where(i => i.Model.IsKnown);
            Assert.That(known.Count(i => Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds), Is.EqualTo(0), "seed " + seed);
            Assert.That(run.Clock.Steps, Is.EqualTo(0), "no clock stepped; seed " + seed);
        }

        [TestCase(1, 5)]
        [TestCase(4, 20)]
        [TestCase(10, -50)]
        public void Steps_OfSeveralResolutions_AreStillFound(double resolutionMs, double stepMs)
        {
            var link = new SimulatedLink(NetworkProfile.Lan, 800, 20) { Resolution = Lengths.Ms(resolutionMs) };
            var run = new PacedRun();
            run.Run(link, 60);

            link.Step = Lengths.Ms(stepMs);
            run.Run(link, 63);

            Assert.That(run.Clock.Steps, Is.EqualTo(1), "seed 800");
        }
    }
}
