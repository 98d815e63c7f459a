using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class MixtureWeightsTests
    {
        const double Interval = 0.1;

        static readonly double[] Prior = { 0.5, 0.5, 0 };

        // The line has replaced the third forecast, which has had too few samples so far.
        [Test]
        public void Solve_ErrorsEqualThoseOfTheLine_GivesTheLineTheWeight()
        {
            var weights = Solved(hold: 1, line: 0.1, other: 0.1);

            Assert.That(weights.Values[ForecasterSet.Line], Is.GreaterThan(0.8));
            Assert.That(weights.Values[2], Is.Zero);
        }

        [Test]
        public void Solve_ErrorsDifferFromThoseOfTheLine_GivesTheBetterForecastTheWeight()
        {
            var weights = Solved(hold: 1, line: 0.1, other: 0.1);

            Learn(weights, hold: 1, line: 0.5, other: 0.1);

            Assert.That(weights.Values[2], Is.GreaterThan(0.5));
        }

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

        static MixtureWeights Solved(double hold, double line, double other)
        {
            var weights = new MixtureWeights(3);
            weights.Solve(Prior, priorEvidence: 0, square: 0);
            Learn(weights, hold, line, other);
            return weights;
        }

        static void Learn(MixtureWeights weights, double hold, double line, double other)
        {
            for (var k = 0; k < 20; k++)
            {
                weights.Learn(new[] { hold, line, other }, first: 0, forgettingFactor: 0.95, share: 1);
                weights.Solve(Prior, priorEvidence: 0.1, square: 0);
            }
        }
    }
}
