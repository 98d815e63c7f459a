using System.Linq;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class SpeedLimitsTests
    {
        const double Interval = 0.05;

        [Test]
        public void At_SpeedLimit_LimitsThePrediction()
        {
            // The joint accelerates and reaches its limit just after the newest sample.
            var free = Fed(PredictionLimits.Unlimited);
            var limited = Fed(With(velocity: 1.0));
            var newest = free.NewestTime;

            Assert.That(free.At(newest + 0.3).Position - free.At(newest + 0.1).Position, Is.GreaterThan(0.21));
            Assert.That(limited.At(newest + 0.3).Position - limited.At(newest + 0.1).Position, Is.LessThan(0.2 + 1e-9));
        }

        [Test]
        public void At_AccelerationLimit_LimitsTheChangeOfSpeed()
        {
            var limited = Fed(With(acceleration: 0.2));
            var newest = limited.NewestTime;
            // The mean speed in the last sampling interval was 0.975 rad/s, which is the speed 25 ms before the newest sample. The speed that is
            // computed here is the speed 287.5 ms after the newest sample.
            var speedThen = (limited.At(newest + 0.3).Position - limited.At(newest + 0.275).Position) / 0.025;

            Assert.That(speedThen, Is.LessThan(0.975 + 0.2 * (0.025 + 0.2875) + 1e-9));
        }

        [Test]
        public void At_SamplesFasterThanTheLimit_AreFollowed()
        {
            var predictor = Predictors.Adaptive(With(velocity: 0.1), MixtureTests.WithoutRepetition);
            for (var k = 0; k < 40; k++) predictor.Add(k * Interval, 2 * k * Interval);

            Assert.That(predictor.At(39 * Interval + 0.1).Position, Is.EqualTo(2 * (39 * Interval + 0.1)).Within(0.01));
        }

        static PredictionLimits With(double velocity = double.PositiveInfinity, double acceleration = double.PositiveInfinity) =>
            new PredictionLimits(
                horizonCap: double.PositiveInfinity, maximumGap: double.PositiveInfinity, velocity: velocity, acceleration: acceleration);

        // Returns a predictor with samples of a joint that accelerates at 1 rad/s² for one second.
        static JointPredictor Fed(PredictionLimits limits) => Predictors.Adaptive(limits, MixtureTests.WithoutRepetition)
            .Fed(Enumerable.Range(0, 21).Select(k => k * Interval), t => 0.5 * t * t);
    }
}
