using Nowpose.Prediction.Mixing;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class DistanceLimitTests
    {
        const double ForgettingFactor = 0.9975;

        static DistanceLimit After(params double[] distances)
        {
            var limit = new DistanceLimit();
            foreach (var distance in distances) limit.Add(distance, ForgettingFactor, isUnconfirmed: false);
            return limit;
        }

        [Test]
        public void Factor_FirstDistance_IsOne()
        {
            Assert.That(After().Factor, Is.EqualTo(1));
            Assert.That(After(0, 0, 5).Factor, Is.EqualTo(1));
        }

        [Test]
        public void Factor_SimilarDistances_IsOne() => Assert.That(After(1, 1.3, 0.2, 1.5, 2).Factor, Is.EqualTo(1));

        [TestCase(3)]
        [TestCase(100)]
        public void Factor_MuchLargerDistance_LimitsItToOneAndAHalfTimesTheMaximum(double distance) =>
            Assert.That(After(1, 2, 0.5, 2 * distance).Factor * 2 * distance, Is.EqualTo(3).Within(0.05));

        [Test]
        public void Factor_SecondLargeDistance_IsOne() => Assert.That(After(1, 100, 100).Factor, Is.EqualTo(1));

        [Test]
        public void Factor_AfterALongTime_DependsOnTheNewerDistances()
        {
            var limit = After(100);
            for (var i = 0; i < 2000; i++) limit.Add(0.1, ForgettingFactor, isUnconfirmed: false);

            limit.Add(50, ForgettingFactor, isUnconfirmed: false);

            Assert.That(limit.Factor * 50, Is.EqualTo(1.5 * 100 * System.Math.Pow(ForgettingFactor, 2000)).Within(0.05));
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void Add_NotFinite_IsIgnored(double distance)
        {
            var limit = After(1, distance);

            limit.Add(1, ForgettingFactor, isUnconfirmed: false);

            Assert.That(limit.Factor, Is.EqualTo(1));
            limit.Add(3, ForgettingFactor, isUnconfirmed: false);
            Assert.That(limit.Factor, Is.EqualTo(0.5).Within(0.01));
        }

        [Test]
        public void Add_DistanceAfterAnUnconfirmedSample_DoesNotIncreaseTheMaximum()
        {
            var limit = After(1);

            limit.Add(100, ForgettingFactor, isUnconfirmed: true);

            Assert.That(limit.Factor, Is.EqualTo(0.015).Within(1e-4));
            limit.Add(3, ForgettingFactor, isUnconfirmed: false);
            Assert.That(limit.Factor, Is.EqualTo(0.5).Within(0.01));
        }

        [Test]
        public void Clear_AfterDistances_RestoresTheInitialState()
        {
            var limit = After(1, 100);

            limit.Clear();

            Assert.That(limit.Factor, Is.EqualTo(1));
            limit.Add(1e6, ForgettingFactor, isUnconfirmed: false);
            Assert.That(limit.Factor, Is.EqualTo(1));
        }
    }
}
