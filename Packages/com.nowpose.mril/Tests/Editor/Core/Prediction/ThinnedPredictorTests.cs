using System;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class ThinnedPredictorTests
    {
        [TestCase(0.010, 100)]
        [TestCase(0.050, 100)]
        [TestCase(0.002, 34)]
        public void Add_FastSource_PassesOnWhatTellsSomething(double interval, int expected)
        {
            var counted = new Counted();
            var predictor = new ThinnedPredictor(counted);
            for (var k = 0; k < 100; k++) predictor.Add(new JointSample(k * interval, k));

            Assert.That(counted.Count, Is.EqualTo(expected));
            Assert.That(predictor.Hold, Is.EqualTo(99));
            Assert.That(predictor.NewestTime, Is.EqualTo(99 * interval));
        }

        [TestCase(0.001)]
        [TestCase(0.002)]
        [TestCase(0.004)]
        public void Adaptive_FastSource_LearnsToo(double interval)
        {
            var random = new Random(8);
            var adaptive = Predictors.Create("adaptive", PredictionLimits.Unlimited);
            var linear = Predictors.Create("linear", PredictionLimits.Unlimited);
            double squares = 0, squaresOfLinear = 0;
            for (var k = 0; k * interval < 20; k++)
            {
                var t = k * interval;
                var sample = new JointSample(t, Motion(t) + 1e-5 * (random.NextDouble() - 0.5));
                adaptive.Add(sample);
                linear.Add(sample);
                if (k % 16 != 0) continue;
                var (a, l) = (adaptive.At(t + 0.1).Position, linear.At(t + 0.1).Position);
                if (t < 5) continue;
                squares += Math.Pow(a - Motion(t + 0.1), 2);
                squaresOfLinear += Math.Pow(l - Motion(t + 0.1), 2);
            }

            Assert.That(squares, Is.LessThan(0.6 * squaresOfLinear), "seed 8");
        }

        static double Motion(double t) => Math.Sin(2 * t) + 0.4 * Math.Sin(5.1 * t + 1);

        sealed class Counted : IJointPredictor
        {
            public int Count { get; private set; }
            public double Hold => 0;
            public double NewestTime { get; private set; } = double.NegativeInfinity;

            public SampleOutcome Add(in JointSample sample)
            {
                Count++;
                NewestTime = sample.Time;
                return SampleOutcome.Accepted;
            }

            public JointPrediction At(double time) => default;

            public void Reset() { }
        }
    }
}
