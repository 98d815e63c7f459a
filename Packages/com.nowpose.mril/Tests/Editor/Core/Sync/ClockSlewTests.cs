using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
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

        /// <summary>
        /// systemd-timesyncd corrects up to 0.4 s by a slew with a time constant of 8 s. Its rate at the start is that of no clock.
        /// </summary>
        [TestCase(0.3)]
        [TestCase(-0.3)]
        public void State_SlewFasterThanAnyClock_IsConvergingDuringTheSlew(double seconds)
        {
            const double Start = 60, TimeConstant = 8;
            double AheadMs(double at) => at < Start ? 0 : seconds * 1000 * (1 - Math.Exp((Start - at) / TimeConstant));
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = new SimulatedLink(NetworkProfile.Named("lan"), seed, skewPpm: 20) { Server = at => (AheadMs(at), 0) };
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 240);

                // The offset is headset time minus control time, so a clock that is ahead reduces it.
                var wrong = run.Instants.Where(i => i.At > Start && ClockSettings.Default.Trusts(i.Model))
                    .Select(i => (i.At, ErrorMs: Math.Abs(i.ErrorMs + AheadMs(i.At)))).ToArray();
                Assert.That(wrong.Where(i => i.At < Start + 120).Max(i => i.ErrorMs), Is.LessThan(25), "two exchanges show the slew; seed " + seed);
                Assert.That(wrong.Where(i => i.At > Start + 2 && i.At < Start + 20), Is.Empty, "the clock is slewed by seconds; seed " + seed);
                Assert.That(wrong.Where(i => i.At > Start + 2).Max(i => i.ErrorMs), Is.LessThan(10), "seed " + seed);
                Assert.That(ClockSettings.Default.Trusts(run.Instants.Last().Model), Is.True, "seed " + seed);
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
