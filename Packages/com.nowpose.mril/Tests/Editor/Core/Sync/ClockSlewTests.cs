using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>
    /// Tests the default estimator while the control clock is slewed, as NTP and PTP do: its rate changes for a minute, and no path changes.
    /// </summary>
    [Category("Study")]
    public class ClockSlewTests
    {
        const int FirstSeed = 600, Seeds = 4;

        /// <summary>
        /// A slew makes one direction late and the other early. If it were mistaken for a longer path, the error would last after the slew.
        /// </summary>
        [TestCase(10)]
        [TestCase(20)]
        public void Error_TwoMinutesAfterASlew_IsAsSmallAsBefore(double ppm)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Slewed("lan", ppm, seed);

                Assert.That(run.PercentileMs(300, 1), Is.LessThan(0.05), "seed " + seed);
            }
        }

        /// <summary>The start of the slew looks like a small step, after which the estimate must not retain the earlier skew.</summary>
        [Test]
        public void Error_HalfAMinuteAfterTheStartOfASlew_IsSmallAgain()
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Slewed("wifi", 100, seed);

                var errors = run.Instants.Where(i => i.At >= 150 && i.At < 180).Select(i => Math.Abs(i.ErrorMs));
                Assert.That(errors.Max(), Is.LessThan(0.3), "seed " + seed);
            }
        }

        // The slew lasts from 120 s to 180 s.
        static SyncRun Slewed(string network, double ppm, int seed)
        {
            const double Interval = 0.2;
            var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm: 20);
            var run = new SyncRun(new DefaultClockEstimator());
            run.Run(link, 0, 120);
            for (var exchange = 0; exchange < 300; exchange++)
            {
                link.Step += Lengths.Ms(ppm * 1e-3 * Interval);
                run.Run(link, 120 + (exchange * Interval), 120 + ((exchange + 1) * Interval));
            }

            run.Run(link, 180, 420);
            return run;
        }
    }
}
