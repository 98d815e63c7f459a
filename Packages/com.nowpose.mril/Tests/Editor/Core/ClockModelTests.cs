using System;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class ClockModelTests
    {
        static readonly HeadsetTime Reference = HeadsetTime.FromSeconds(1000);

        static ClockModel Model(double offsetSeconds, double skew) => new ClockModel(
            Reference, new ClockOffset(Lengths.Seconds(offsetSeconds)), skew, TimeSpan.FromMilliseconds(1), ClockState.Synchronised);

        [TestCase(1234.5, 0)]
        [TestCase(-1.7e9, 80e-6)]
        [TestCase(1.7e9, -80e-6)]
        public void ToHeadset_ResultOfToControl_ReturnsTheOriginalTime(double offsetSeconds, double skew)
        {
            var model = Model(offsetSeconds, skew);

            foreach (var age in new[] { -300.0, 0, 0.0123456, 3600 })
            {
                var t = Reference + Lengths.Seconds(age);
                Assert.That(Math.Abs((model.ToHeadset(model.ToControl(t)) - t).Ticks), Is.LessThanOrEqualTo(1), "at " + age + " s");
            }
        }

        [Test]
        public void OffsetAt_HeadsetClockRunsFast_GrowsWithTime()
        {
            var model = Model(5, 50e-6);

            var grown = model.OffsetAt(Reference + TimeSpan.FromSeconds(100)) - model.ReferenceOffset;

            Assert.That(grown, Is.EqualTo(TimeSpan.FromMilliseconds(5)));
        }

        [Test]
        public void ToControl_HeadsetClockAhead_ReturnsAnEarlierTime()
        {
            Assert.That(Model(2, 0).ToControl(Reference), Is.EqualTo(ControlTime.FromSeconds(998)));
        }

        [Test]
        public void ToControl_Unsynchronised_Throws()
        {
            Assert.Throws<InvalidOperationException>(() => default(ClockModel).ToControl(Reference));
        }
    }
}
