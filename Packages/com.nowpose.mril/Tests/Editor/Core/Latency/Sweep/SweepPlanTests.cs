using System;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Sweep
{
    public class SweepPlanTests
    {
        [Test]
        public void Loads_Up_RiseFromZeroToTheMaximum()
        {
            var plan = new SweepPlan(1_000_000, 4, goesDown: false);

            Assert.That(plan.Loads, Is.EqualTo(new[] { 0, 250_000, 500_000, 750_000, 1_000_000 }));
        }

        [Test]
        public void Loads_UpAndDown_TurnAtTheMaximumAndEndAtZero()
        {
            var plan = new SweepPlan(steps: 3);

            Assert.That(plan.Loads, Is.EqualTo(new[] { 0, 666_666, 1_333_333, 2_000_000, 1_333_333, 666_666, 0 }));
        }

        [Test]
        public void Duration_AllLoads_IncludesTheTimeToSettle()
        {
            var plan = new SweepPlan(steps: 10, secondsPerLoad: 5, settleSeconds: 1);

            Assert.That(plan.Duration, Is.EqualTo(new TimeSpan(0, 2, 6)));
        }

        [TestCase(2_000_001, 10, 5, 1, SettingNames.MaxSweepLoad, 2_000_001, "", 1000, 2_000_000)]
        [TestCase(2_000_000, 1, 5, 1, SettingNames.SweepSteps, 1, "", 2, 100)]
        [TestCase(2_000_000, 10, 0, 1, SettingNames.LoadTime, 0, " s", 0.5, 600)]
        [TestCase(2_000_000, 10, 5, double.NaN, SettingNames.SettlingTime, double.NaN, " s", 0, 60)]
        public void Constructor_ValueOutOfRange_NamesTheValue(
            int most, int steps, double seconds, double settle, string name, double value, string unit, double min, double max)
        {
            Assert.That(
                () => new SweepPlan(most, steps, seconds, settle),
                Throws.TypeOf<InputException>().With.Message.EqualTo(SettingMessages.OutOfRange(name, value, unit, min, max)));
        }
    }
}
