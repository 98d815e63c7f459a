using System;
using Nowpose.Latency;
using Nowpose.Latency.Calibration;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Calibration
{
    public class AxisSpeedTests
    {
        static AxisSpeed Moved(Func<double, double> mmAt, int frames = 60)
        {
            var speed = new AxisSpeed();
            for (var i = 0; i < frames; i++) speed.Add(new ControlTime(TimeSpan.FromTicks((long)(1e13 + i / 60.0 * 1e7))), mmAt(i / 60.0));
            return speed;
        }

        [TestCase(250)]
        [TestCase(-80)]
        public void MmPerS_NoisyConstantSpeed_EqualsTheSpeed(double mmPerS)
        {
            var random = new Random(2);

            var speed = Moved(t => 1000 + mmPerS * t + 0.1 * (random.NextDouble() - 0.5));

            Assert.That(speed.MmPerS.Value, Is.EqualTo(mmPerS).Within(0.5), "seed 2");
            Assert.That(speed.IsConstant, Is.True);
        }

        [Test]
        public void IsConstant_Accelerating_IsFalse()
        {
            Assert.That(Moved(t => 250 * t * t).IsConstant, Is.False);
        }

        // The means of the two halves of the window are 0.25 s apart. At the newest 30 frames, the mean speed is 300 mm/s.
        [TestCase(110, true)]
        [TestCase(130, false)]
        [TestCase(-110, true)]
        [TestCase(-130, false)]
        public void IsConstant_SlowAcceleration_IsTrueUpToATenthOfTheSpeed(double acceleration, bool expected)
        {
            var speed = Moved(t => 300 * (t - 0.75) + 0.5 * acceleration * (t - 0.75) * (t - 0.75));

            Assert.That(speed.IsConstant, Is.EqualTo(expected));
        }

        [Test]
        public void MmPerS_FewFrames_IsNull()
        {
            Assert.That(Moved(t => 250 * t, 29).MmPerS, Is.Null);
            Assert.That(Moved(t => 250 * t, 29).IsConstant, Is.False);
            Assert.That(Moved(t => 250 * t, 30).MmPerS, Is.Not.Null);
        }

        [Test]
        public void Add_ClockWentBack_DiscardsEarlierFrames()
        {
            var speed = Moved(t => 250 * t);

            speed.Add(new ControlTime(TimeSpan.FromTicks(50_000_000)), 0);

            Assert.That(speed.MmPerS, Is.Null);
        }
    }
}
