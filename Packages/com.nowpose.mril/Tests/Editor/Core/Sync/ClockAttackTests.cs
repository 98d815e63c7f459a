using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>An attacker delays packets, or the owner of the control clock manipulates it. Tests which attacks the headset detects.</summary>
    [Category("Study")]
    public class ClockAttackTests
    {
        const int FirstSeed = 300;

        /// <summary>A delay in one direction shifts the clock by half of it. The round-trip time shows it, so the error bound covers it.</summary>
        [TestCase("lan", 0.05)]
        [TestCase("wifi", 0.05)]
        [TestCase("wifi", 0.5)]
        [TestCase("wifi", 5)]
        public void Delay_OneDirectionGrows_ErrorStaysWithinTheBound(string network, double msASecond)
        {
            for (var seed = FirstSeed; seed < FirstSeed + 4; seed++)
            {
                var link = new SimulatedLink(NetworkProfile.Named(network), seed, skewPpm: 20);
                var run = new SyncRun(new EnvelopeClockEstimator());
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

        /// <summary>A ramp within the skew of real quartz clocks cannot be distinguished from one, so the estimate follows it.</summary>
        [TestCase(50)]
        [TestCase(-50)]
        public void Ramp_ControlClockAsSlowAsAQuartz_IsFollowed(double ppm)
        {
            for (var seed = FirstSeed; seed < FirstSeed + 4; seed++)
            {
                var run = Ramped(ppm, seed);

                Assert.That(run.PercentileMs(100, 0.95), Is.LessThan(2), "seed " + seed);
            }
        }

        /// <summary>A ramp faster than any real clock is a series of steps, each of which is reported.</summary>
        [TestCase(20_000)]
        [TestCase(-20_000)]
        public void Ramp_FasterThanAnyClock_IsFoundAsSteps(double ppm)
        {
            for (var seed = FirstSeed; seed < FirstSeed + 4; seed++)
                Assert.That(Ramped(ppm, seed).Clock.Steps, Is.GreaterThanOrEqualTo(1), "seed " + seed);
        }

        static SyncRun Ramped(double ppm, int seed)
        {
            const double Interval = 0.2;
            var link = new SimulatedLink(NetworkProfile.Named("wifi"), seed, skewPpm: 20);
            var run = new SyncRun(new EnvelopeClockEstimator());
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
