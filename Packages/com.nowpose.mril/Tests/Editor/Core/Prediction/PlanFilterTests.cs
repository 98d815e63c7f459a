using Nowpose.Prediction.Planning;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class PlanFilterTests
    {
        // The tolerance at the start of a plan accepts an offset of a tenth of the range, or a delay of half a second.
        [TestCase(0.3, 0)]
        [TestCase(0.8, 1)]
        public void Add_AfterMinutesWithoutFollowing_AcceptsNoMoreThanAtTheStart(double difference, double velocity)
        {
            var filter = new PlanFilter();
            filter.Start(range: 1);
            for (var second = 1; second <= 3600; second++)
                Assert.That(filter.Add(second, difference: 10, velocity: 0, range: 1), Is.EqualTo(PlanVerdict.NotFollowed));

            Assert.That(filter.Add(3601, difference, velocity, range: 1), Is.EqualTo(PlanVerdict.NotFollowed));
        }

        [TestCase(0.09, 0)]
        [TestCase(0.45, 1)]
        public void Add_FirstSampleWithinTheTolerance_IsAccepted(double difference, double velocity)
        {
            var filter = new PlanFilter();
            filter.Start(range: 1);

            Assert.That(filter.Add(1, difference, velocity, range: 1), Is.Not.EqualTo(PlanVerdict.NotFollowed));
        }
    }
}
