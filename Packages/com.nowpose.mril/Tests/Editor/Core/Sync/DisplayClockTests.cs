using System;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    public class DisplayClockTests
    {
        static ClockModel Model(double offsetMs, ClockState state = ClockState.Synchronised, int steps = 0, double atSeconds = 0) => new ClockModel(
            HeadsetTime.FromSeconds(atSeconds), new ClockOffset(Lengths.Ms(offsetMs)), 0, TimeSpan.FromMilliseconds(1), state, steps);

        static double ShownMs(DisplayClock clock, in ClockModel estimate, double seconds)
        {
            var now = HeadsetTime.FromSeconds(seconds);
            return clock.Follow(estimate, now).OffsetAt(now).HeadsetMinusControl.TotalMilliseconds;
        }

        [TestCase("lan", "default", 60.0)]
        [TestCase("wifi", "default", 60.0)]
        [TestCase("busy-wifi", "default", 60.0)]
        [TestCase("busy-wifi", "ransac", 60.0)]
        [TestCase("wifi", "default", 5000.0, Category = "Study")]
        [TestCase("busy-wifi", "ransac", 5000.0, Category = "Study")]
        public void ControlTime_IncreasingHeadsetTimes_NeverGoesBackWithoutAStep(string network, string estimator, double callsPerSecond)
        {
            for (var seed = 300; seed < 303; seed++)
            {
                var link = new SimulatedLink(NetworkProfile.Named(network), seed, 80, 2, 0.02) { Load = SimulatedLink.Queues };
                var random = new Random(seed);
                var clock = new ClockSynchroniser(ClockEstimators.Create(estimator), ClockSettings.Default);
                var display = new DisplayClock();
                SyncExchange? underway = null;
                ControlTime? last = null;
                var min = TimeSpan.MaxValue;
                var next = 0.0;
                for (var s = 0.0; s < 30; s += 2 * random.NextDouble() / callsPerSecond)
                {
                    var now = HeadsetTime.FromSeconds(s);
                    // A reply may reach the clock up to 1 ms after its arrival, because the network thread may be delayed.
                    if (underway?.T4 <= now - Lengths.Ms(random.NextDouble()))
                    {
                        clock.Add(underway.Value, out _);
                        underway = null;
                    }
                    if (underway == null && s >= next)
                    {
                        if (link.TryExchange(now, out var exchange)) underway = exchange;
                        next = s + 0.1;
                    }
                    var shown = display.Follow(clock.ModelAt(now), now);
                    if (!shown.IsKnown) continue;
                    var control = shown.ToControl(now);
                    if (last.HasValue && control - last.Value < min) min = control - last.Value;
                    last = control;
                }
                Assert.That(min, Is.GreaterThanOrEqualTo(TimeSpan.Zero), "seed " + seed);
                Assert.That(clock.Steps, Is.EqualTo(0), "seed " + seed);
            }
        }

        [Test]
        public void Follow_SmallCorrection_IsAppliedAtALimitedRate()
        {
            var clock = new DisplayClock();
            ShownMs(clock, Model(10), 0);
            var better = Model(9);

            Assert.That(ShownMs(clock, better, 0.1), Is.EqualTo(9.5).Within(1e-3), "5 ms/s");
            Assert.That(ShownMs(clock, better, 0.19), Is.GreaterThan(9));
            Assert.That(ShownMs(clock, better, 0.21), Is.EqualTo(9).Within(1e-3));
        }

        [Test]
        public void Follow_WhileSlewing_BoundIncludesTheRemainingCorrection()
        {
            var clock = new DisplayClock();
            clock.Follow(Model(10), HeadsetTime.FromSeconds(0));

            var shown = clock.Follow(Model(9), HeadsetTime.FromSeconds(0.1));

            Assert.That(shown.ErrorBound.TotalMilliseconds, Is.EqualTo(1 + 0.5).Within(1e-3));
        }

        [TestCase(10)]
        [TestCase(-10)]
        public void Follow_Converging_AppliesTheCorrectionFaster(int correctionMs)
        {
            var clock = new DisplayClock();
            ShownMs(clock, Model(0, ClockState.Converging), 0);
            var better = Model(correctionMs, ClockState.Converging);

            Assert.That(ShownMs(clock, better, 0.016), Is.EqualTo(correctionMs * 0.8).Within(1e-3), "half of 16 ms");
            Assert.That(ShownMs(clock, better, 0.032), Is.EqualTo(correctionMs).Within(1e-3));
        }

        [TestCase(1100)]
        [TestCase(-33_000)]
        public void Follow_CorrectionOfMoreThanASecond_TakesEffectAtOnce(int correctionMs)
        {
            var clock = new DisplayClock();
            ShownMs(clock, Model(0, ClockState.Converging), 0);

            Assert.That(ShownMs(clock, Model(correctionMs, ClockState.Converging), 0.016), Is.EqualTo(correctionMs));
            Assert.That(clock.IsRestarted);
        }

        // The estimate is coarse from the first exchange after a silence on, but the displayed clock is not accurate yet.
        [Test]
        public void Follow_LargeCorrectionOfACoarseClock_IsConvergingUntilItIsApplied()
        {
            var clock = new DisplayClock();
            clock.Follow(Model(0, ClockState.Coarse), HeadsetTime.FromSeconds(0));

            var first = clock.Follow(Model(20, ClockState.Coarse), HeadsetTime.FromSeconds(0.01));
            var last = clock.Follow(Model(20, ClockState.Coarse), HeadsetTime.FromSeconds(0.06));

            Assert.That(first.State, Is.EqualTo(ClockState.Converging));
            Assert.That(last.State, Is.EqualTo(ClockState.Coarse));
            Assert.That(last.ReferenceOffset.HeadsetMinusControl, Is.EqualTo(Lengths.Ms(20)));
        }

        [Test]
        public void Follow_ClockStep_IsAppliedImmediately()
        {
            var clock = new DisplayClock();
            ShownMs(clock, Model(0), 0);

            Assert.That(ShownMs(clock, Model(5000, steps: 1), 0.016), Is.EqualTo(5000));
        }

        [Test]
        public void Follow_AfterALongPause_EqualsTheEstimate()
        {
            var clock = new DisplayClock();
            ShownMs(clock, Model(0), 0);

            Assert.That(ShownMs(clock, Model(20), 60), Is.EqualTo(20), "no frame was shown while the headset slept");
        }

        [Test]
        public void Follow_EstimateWithLargeSkew_DoesNotGoBack()
        {
            var clock = new DisplayClock();
            var steep = new ClockModel(default, default, 1.5, TimeSpan.FromMilliseconds(50), ClockState.Converging);
            clock.Follow(steep, HeadsetTime.FromSeconds(0));

            var now = HeadsetTime.FromSeconds(0.016);
            Assert.That(clock.Follow(steep, now).ToControl(now), Is.GreaterThan(ControlTime.FromSeconds(0)));
        }

        [Test]
        public void Follow_UnknownClock_ReturnsAnUnknownModel()
        {
            Assert.That(new DisplayClock().Follow(default, HeadsetTime.FromSeconds(1)).IsKnown, Is.False);
        }
    }
}
