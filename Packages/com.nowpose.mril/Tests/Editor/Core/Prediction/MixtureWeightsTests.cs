using System;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class MixtureWeightsTests
    {
        const double Interval = 0.1;

        // A jump is not a fast motion, for which the weights would approach the prior.
        [Test]
        public void At_JointThatJumpsBetweenRests_IsNearlyAsAccurateAsHold()
        {
            double squares = 0, held = 0;
            for (var seed = 0; seed < 20; seed++)
            {
                var (predictor, random, place, next) = (Predictors.Create("adaptive", new PredictionLimits()), new Random(seed), 0.0, 0.0);
                var places = new double[300];
                for (var k = 0; k < places.Length; k++)
                {
                    if (k * Interval >= next) (place, next) = (place + 0.4 * (random.NextDouble() - 0.5), next + 0.5 + 1.5 * random.NextDouble());
                    places[k] = place;
                }
                for (var k = 0; k + 2 < places.Length; k++)
                {
                    predictor.Add(new JointSample(k * Interval, places[k]), k * Interval + 0.15);
                    if (k < 4) continue;
                    squares += Math.Pow(predictor.At(k * Interval + 0.2).Position - places[k + 2], 2);
                    held += Math.Pow(places[k] - places[k + 2], 2);
                }
            }

            Assert.That(Math.Sqrt(squares / held), Is.LessThan(1.1));
        }
    }
}
