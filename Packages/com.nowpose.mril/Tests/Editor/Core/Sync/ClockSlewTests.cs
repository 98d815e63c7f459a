using System;
using System.Collections.Generic;
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
        const double Start = 60, End = 240;

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
        /// On WiFi, a slew may be mistaken for a change of the path. The offset is then outside the bounds of all recent exchanges, which are about
        /// 3 ms apart.
        /// </summary>
        [Test]
        public void Error_SlewMistakenForAPathChange_ReturnsToTheBoundsOfTheExchanges()
        {
            for (var seed = FirstSeed; seed < FirstSeed + 2 * Seeds; seed++)
            {
                var run = Slewed("wifi", 40, seed, seconds: 250);

                Assert.That(run.PercentileMs(490, 1), Is.LessThan(2.5), "seed " + seed);
                Assert.That(run.Instants.Where(i => i.At >= 490).All(i => ClockSettings.Default.Trusts(i.Model)), Is.True, "seed " + seed);
            }
        }

        /// <summary>
        /// A line that was outside the bounds before a pause, and still is with the first exchange after it, restarts at once. If the time began
        /// again with this exchange, the largest errors would last 10 s longer.
        /// </summary>
        [Test]
        public void Error_PausesDuringAndAfterASlew_IsSmallSoonAfterThem()
        {
            const double Pause = 55, Soon = 12;
            var errors = new List<double>();
            for (var seed = FirstSeed; seed < FirstSeed + 4 * Seeds; seed++)
            {
                var link = new SimulatedLink(NetworkProfile.Named("lan"), seed, skewPpm: 20);
                var run = new SyncRun(new DefaultClockEstimator());
                var random = new Random(seed);
                run.Run(link, 0, 120);
                for (var at = 120.0; at < 1000;)
                {
                    var (ppm, begin, pause) = (at < 320 ? 20 : 0, at, at + 8 + 0.2 * random.Next(60));
                    at = pause + Pause;
                    Slew(run, link, ppm, begin, pause);
                    if (begin > 120) errors.AddRange(run.Instants.Where(i => i.At >= begin && i.At < begin + Soon).Select(i => Math.Abs(i.ErrorMs)));
                    Slew(run, link, ppm, pause, at, exchange: false);
                }
            }

            Assert.That(errors, Has.None.NaN);
            errors.Sort();
            Assert.That(errors[(int)(0.95 * errors.Count)], Is.LessThan(0.9), $"seeds {FirstSeed} to {FirstSeed + 4 * Seeds - 1}");
        }

        /// <summary>After the restart that corrects such a mistake, the exchanges from before must not be mistaken for a clock step.</summary>
        [Test]
        public void Steps_SlewMistakenForAPathChangeOnABusyNetwork_DoNotIncreaseAfterTheSlew()
        {
            for (var seed = FirstSeed; seed < FirstSeed + 2; seed++)
            {
                var run = Slewed("wifi", 40, seed, seconds: 250, isBusy: true);

                var steps = run.Instants.Where(i => i.At >= 400).Select(i => i.Model.Steps).Distinct();
                Assert.That(steps.Count(), Is.EqualTo(1), "seed " + seed);
            }
        }

        /// <summary>
        /// systemd-timesyncd corrects up to 0.4 s by a slew with a time constant of 8 s. Its rate at the start is that of no clock. The two exchanges
        /// that show it take a second and 50 ms at the slow pace, which a LAN allows, and 250 ms at the usual pace.
        /// </summary>
        [TestCase(0.3, true, 40)]
        [TestCase(-0.3, true, 40)]
        [TestCase(0.3, false, 10)]
        [TestCase(-0.3, false, 10)]
        public void State_SlewFasterThanAnyClock_IsConvergingDuringTheSlew(double seconds, bool maySlow, double limitMs)
        {
            const double TimeConstant = 8;
            double AheadMs(double at) => at < Start ? 0 : seconds * 1000 * (1 - Math.Exp((Start - at) / TimeConstant));
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var wrong = FromTheStart("lan", seed, AheadMs, maySlow).Where(i => i.IsTrusted).ToArray();

                Assert.That(wrong.Max(i => i.ErrorMs), Is.LessThan(limitMs), "two exchanges show the slew; seed " + seed);
                Assert.That(wrong.Where(i => i.At > Start + 2 && i.At < Start + 20), Is.Empty, "the clock is slewed by seconds; seed " + seed);
                Assert.That(wrong.Where(i => i.At > Start + 2).Max(i => i.ErrorMs), Is.LessThan(10), "seed " + seed);
                Assert.That(wrong.Last().At, Is.GreaterThan(End - 1), "seed " + seed);
            }
        }

        /// <summary>Steps to and fro are not a slew, however many there are: the clock is right between them.</summary>
        [TestCase("lan", 0.4, 9)]
        [TestCase("lan", 0.5, 9)]
        [TestCase("lan", 10, 9)]
        [TestCase("wifi", 2, 9.5)]
        public void State_StepsToAndFro_IsCurrentBetweenThem(string network, double stepMs, double intervalSeconds) =>
            AssertIsCurrent(network, at => at < Start || (int)((at - Start) / intervalSeconds) % 2 == 1 ? 0 : stepMs);

        /// <summary>A clock that is 125 ppm too fast is set back by a millisecond every 8 s.</summary>
        [Test]
        public void State_SkewCorrectedBySteps_IsCurrentBetweenThem() => AssertIsCurrent("lan", at => at < Start ? 0 : (at - Start) % 8 / 8);

        static void AssertIsCurrent(string network, Func<double, double> aheadMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var share = FromTheStart(network, seed, aheadMs).Average(i => i.IsTrusted ? 1 : 0);

                Assert.That(share, Is.GreaterThan(0.95), "seed " + seed);
            }
        }

        // Returns the errors from the start of the changes of the control clock on, at the pace of the headset.
        static (double At, double ErrorMs, bool IsTrusted)[] FromTheStart(
            string network, int seed, Func<double, double> aheadMs, bool maySlow = true)
        {
            var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm: 20) { Server = at => (aheadMs(at), 0) };
            var run = new PacedRun(seed: seed, maySlow: maySlow);
            run.Run(link, End);
            // The offset is headset time minus control time, so a clock that is ahead reduces it.
            return run.Errors.Where(i => i.At > Start).Select(i => (i.At, Math.Abs(i.ErrorMs + aheadMs(i.At)), i.IsTrusted)).ToArray();
        }

        // The slew starts at 120 s. The run lasts for four minutes after its end.
        static SyncRun Slewed(string network, double ppm, int seed, double seconds = 60, bool isBusy = false)
        {
            var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm: 20);
            if (isBusy) link.Load = SimulatedLink.Queues;
            var run = new SyncRun(new DefaultClockEstimator());
            run.Run(link, 0, 120);
            Slew(run, link, ppm, 120, 120 + seconds);
            run.Run(link, 120 + seconds, 360 + seconds);
            return run;
        }

        static void Slew(SyncRun run, SimulatedLink link, double ppm, double from, double to, bool exchange = true)
        {
            const double Interval = 0.2;
            for (var step = 0; step < (to - from) / Interval; step++)
            {
                link.Step += Lengths.Ms(ppm * 1e-3 * Interval);
                run.Run(link, from + (step * Interval), from + ((step + 1) * Interval), exchange);
            }
        }
    }
}
