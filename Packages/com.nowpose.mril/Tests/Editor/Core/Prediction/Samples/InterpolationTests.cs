using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Samples
{
    public class InterpolationTests
    {
        // Uneven intervals.
        static readonly double[] Times = { 10, 10.05, 10.09, 10.16, 10.2, 10.24, 10.31, 10.35 };

        static JointPredictor New(int degree = 2, int history = 2, PredictionLimits limits = null) =>
            TestPredictors.Of(new PolynomialForecaster(degree, history), limits, PredictionParts.Interpolation);

        static JointPredictor Of(Func<double, double> position, int history = 2, PredictionLimits limits = null) =>
            New(2, history, limits).Fed(Times, position);

        static double MaxError(JointPredictor predictor, Func<double, double> position)
        {
            var max = 0.0;
            for (var t = Times[0]; t <= Times[Times.Length - 1]; t += 0.001)
                max = Math.Max(max, Math.Abs(predictor.At(t).Position - position(t)));
            return max;
        }

        [TestCase(10.18)]
        [TestCase(9)]
        [TestCase(10.32)]
        public void At_QuadraticMotion_IsExactForAnyTurningPoint(double turn)
        {
            Func<double, double> motion = t => 0.3 + 2 * (t - turn) * (t - turn);

            var predictor = Of(motion);

            Assert.That(MaxError(predictor, motion), Is.LessThan(1e-12));
            Assert.That(predictor.At(10.1).Kind, Is.EqualTo(PredictionKind.Interpolated));
        }

        [Test]
        public void At_SmoothMotion_IsFarMoreAccurateThanLinearInterpolation()
        {
            Func<double, double> motion = t => Math.Sin(5 * t);

            // The error of a straight line over 70 ms is up to 5²·0.07²/8 = 0.0153.
            Assert.That(MaxError(Of(motion), motion), Is.InRange(1e-5, 0.0153 / 10));
        }

        [TestCase(10.09)]
        [TestCase(10.15)]
        public void At_MonotoneStep_DoesNotOvershoot(double step)
        {
            var predictor = Of(t => t > step ? 1 : 0);

            var last = 0.0;
            for (var t = Times[0]; t <= Times[Times.Length - 1]; t += 0.001)
            {
                var position = predictor.At(t).Position;
                Assert.That(position, Is.GreaterThanOrEqualTo(last - 1e-12), "falls at " + t);
                last = position;
            }
            Assert.That(last, Is.EqualTo(1).Within(1e-12));
        }

        [Test]
        public void At_SampleTimes_EqualsTheSamplesWithoutAKink()
        {
            Func<double, double> motion = t => Math.Sin(40 * t) + (t > 10.2 ? 1 : 0);
            var predictor = Of(motion);

            for (var i = 1; i < Times.Length - 1; i++)
            {
                const double d = 1e-6;
                var (before, at, after) = (predictor.At(Times[i] - d).Position, predictor.At(Times[i]).Position, predictor.At(Times[i] + d).Position);
                Assert.That(at, Is.EqualTo(motion(Times[i])).Within(1e-12));
                Assert.That((after - at) / d, Is.EqualTo((at - before) / d).Within(0.05), "slope at sample " + i);
            }
        }

        [TestCase("adaptive")]
        [TestCase("gp")]
        public void At_DisplayOvertakesTheSamples_DoesNotJump(string name)
        {
            var predictor = Predictors.Create(name, PredictionLimits.Unlimited);
            for (var k = 0; k < 200; k++)
            {
                predictor.Add(k * 0.05, Math.Sin(0.4 * k));
                if (k < 10) continue;

                Assert.That(predictor.At(k * 0.05 + 1e-9).Position, Is.EqualTo(predictor.At(k * 0.05).Position).Within(1e-4), "sample " + k);
                Assert.That(predictor.At(k * 0.05 + 0.05).Kind, Is.EqualTo(PredictionKind.Predicted));
            }
        }

        [Test]
        public void At_BeforeTheOldestSample_HoldsIt()
        {
            var predictor = Of(t => t);

            Assert.That(predictor.At(9.9).Position, Is.EqualTo(10).Within(1e-12));
            Assert.That(predictor.At(9.9).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void At_LongGap_IsNotInterpolated()
        {
            var predictor = New(1, 1, new PredictionLimits(maximumGap: 0.5)).Fed(new[] { 1, 1.05, 3, 3.05 }, t => t > 2 ? 5 : 0);

            Assert.That(predictor.At(2).Kind, Is.Not.EqualTo(PredictionKind.Interpolated));
            Assert.That(predictor.At(3.02).Kind, Is.EqualTo(PredictionKind.Interpolated));
        }

        [Test]
        public void At_OvertakenSample_IsUsedInOrder()
        {
            Func<double, double> motion = t => (t - 10) * (t - 10);
            var predictor = New(2, 6);
            foreach (var i in new[] { 0, 1, 2, 4, 3, 5 }) predictor.Add(Times[i], motion(Times[i]));

            Assert.That(predictor.At(Times[3]).Position, Is.EqualTo(motion(Times[3])).Within(1e-12));
        }

        // The order of wrong stamps may differ from the order of the samples. The curve omits samples whose stamp is earlier than that of the
        // previous sample.
        [Test]
        public void At_StampsOutOfOrder_StaysFinite()
        {
            var predictor = New();
            var random = new Random(5);
            for (var i = 0; i < 200; i++)
            {
                predictor.Add(new JointSample(i * 0.02 + 0.05 * random.NextDouble(), Math.Sin(i), i * 0.02));
                for (var t = -0.2; t < 0.2; t += 0.013) Assert.That(predictor.At(i * 0.02 + t).Position, Is.InRange(-1e6, 1e6), "seed 5");
            }
        }

        [Test]
        public void At_BeyondTheJointsLimit_IsClamped()
        {
            var predictor = Of(t => 50 * (t - 10.18) * (t - 10.18), limits: new PredictionLimits(lower: 0.02, upper: 1));

            for (var t = Times[0]; t < 10.5; t += 0.001) Assert.That(predictor.At(t).Position, Is.InRange(0.02, 1));
        }

        [Test]
        public void Reset_AfterSamples_ClearsThem()
        {
            var predictor = Of(t => t);

            predictor.Reset();

            Assert.That(predictor.At(10.1).Kind, Is.EqualTo(PredictionKind.None));
        }
    }
}
