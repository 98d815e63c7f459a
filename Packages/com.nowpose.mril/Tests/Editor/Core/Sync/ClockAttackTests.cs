using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>Tests which attacks the headset detects: delayed packets and a manipulated control clock.</summary>
    [Category("Study")]
    public class ClockAttackTests
    {
        const int FirstSeed = 300;

        /// <summary>
        /// A delay in one direction shifts the estimated offset by half the delay. It also lengthens the round-trip time, so the error bound
        /// covers the shift.
        /// </summary>
        [TestCase("lan", 0.05)]
        [TestCase("wifi", 0.05)]
        [TestCase("wifi", 0.5)]
        [TestCase("wifi", 5)]
        public void Delay_OneDirectionGrows_ErrorStaysWithinTheBound(string network, double msASecond)
        {
            for (var seed = FirstSeed; seed < FirstSeed + 4; seed++)
            {
                var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm: 20);
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, 60);
                for (var second = 60; second < 120; second++)
                {
                    link.LongerUpMs += msASecond;
                    run.Run(link, second, second + 1);
                }

                var outside = run.Instants.Where(i => i.At > 61 && Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds).ToArray();
                Assert.That(outside.Select(i => (i.At, i.ErrorMs, i.Model.ErrorBound)), Is.Empty, "seed " + seed);
            }
        }

        /// <summary>
        /// A ramp of the control clock within the skew of quartz clocks cannot be distinguished from an honest clock, so the estimate
        /// follows it.
        /// </summary>
        [TestCase(50)]
        [TestCase(-50)]
        public void Ramp_WithinTheSkewOfQuartzClocks_IsFollowed(double ppm)
        {
            for (var seed = FirstSeed; seed < FirstSeed + 4; seed++)
            {
                var run = Ramped(ppm, seed);

                Assert.That(run.PercentileMs(100, 0.95), Is.LessThan(2), "seed " + seed);
            }
        }

        /// <summary>A ramp faster than the skew of any real clock is detected as clock steps.</summary>
        [TestCase(20_000)]
        [TestCase(-20_000)]
        public void Ramp_FasterThanAnyRealClock_IsDetectedAsSteps(double ppm)
        {
            for (var seed = FirstSeed; seed < FirstSeed + 4; seed++)
                Assert.That(Ramped(ppm, seed).Clock.Steps, Is.GreaterThanOrEqualTo(1), "seed " + seed);
        }

        static SyncRun Ramped(double ppm, int seed)
        {
            const double Interval = 0.2;
            var link = new SimulatedLink(NetworkProfile.Named("wifi"), seed, skewPpm: 20);
            var run = new SyncRun(new DefaultClockEstimator());
            run.Run(link, 0, 60);
            for (var exchange = 0; exchange < 300; exchange++)
            {
                link.Step += Lengths.Ms(ppm * 1e-3 * Interval);
                run.Run(link, 60 + (exchange * Interval), 60 + ((exchange + 1) * Interval));
            }

            return run;
        }
    }
}
