using Nowpose.Benchmarks.Comparison;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>Tests that the competing predictors work as their authors intended, because a faulty filter would make the comparison unfair.</summary>
public class CompetitorTests
{
    const double Interval = 0.05;
    const double Ahead = 0.1;
    const int Samples = 60;
    const int Lost = 40;

    [TestCase("MathNet")]
    [TestCase("Kalman")]
    [TestCase("double-exponential")]
    public void At_LineWithOneLostSample_IsExact(string name)
    {
        Assert.That(ErrorOf(name, t => 30 - 400 * t), Is.LessThan(1e-6));
    }

    [TestCase("MathNet", 1e-6)]
    [TestCase("Kalman", 1e-3)]
    public void At_ParabolaWithOneLostSample_IsExact(string name, double within)
    {
        Assert.That(ErrorOf(name, t => 30 - 400 * t + 900 * t * t), Is.LessThan(within));
    }

    [Test]
    public void DoubleExponential_Parabola_ErrsLikeALine()
    {
        // A straight line through two samples errs by a (h² + h T) / 2, with the acceleration a, the horizon h and the sampling interval T.
        Assert.That(ErrorOf("double-exponential", t => 900 * t * t), Is.EqualTo(900 * (Ahead * Ahead + Ahead * Interval)).Within(0.5));
    }

    [Test]
    public void PolynomialFit_SamplesOutOfOrder_EqualsTheQuadratic()
    {
        const int seed = 5;
        var random = new Random(seed);
        var (theirs, ours) = (ComparedPredictors.Named("MathNet").Create(), Predictors.Create("quadratic", PredictionLimits.Unlimited));

        for (var i = 0; i < Samples; i++)
        {
            var sample = new JointSample((i + 1.5 * random.NextDouble()) * Interval, 100 * random.NextDouble());
            Assert.That(theirs.Add(sample), Is.EqualTo(ours.Add(sample)), $"seed {seed}, sample {i}");
            var expected = ours.At(ours.NewestTime + Ahead).Position;

            Assert.That(theirs.At(theirs.NewestTime + Ahead).Position, Is.EqualTo(expected).Within(1e-9 * (1000 + Math.Abs(expected))), $"seed {seed}, sample {i}");
        }
    }

    [Test]
    public void OneEuro_NoiseAtRest_SmoothsTheNoise()
    {
        // A low-pass filter of 1 Hz weights each sample with a = 0.24, so the factor for white noise is √(a / (2 − a)) = 0.37.
        Assert.That(NoiseLeft(ComparedPredictors.OneEuro(1, 0, 1), ahead: 0), Is.EqualTo(0.37).Within(0.05));
    }

    [Test]
    public void Kalman_LowerJerkToNoiseRatio_SmoothsMore()
    {
        var (stiff, limp) = (NoiseLeft(ComparedPredictors.Kalman(1e3), Ahead), NoiseLeft(ComparedPredictors.Kalman(1e9), Ahead));

        Assert.That(stiff, Is.LessThan(2));
        Assert.That(limp, Is.GreaterThan(2 * stiff));
    }

    static double ErrorOf(string name, Func<double, double> motion)
    {
        var predictor = ComparedPredictors.Named(name).Create();
        for (var i = 0; i < Samples; i++)
            if (i != Lost) predictor.Add(new JointSample(i * Interval, motion(i * Interval)));
        var time = (Samples - 1) * Interval + Ahead;
        return Math.Abs(predictor.At(time).Position - motion(time));
    }

    // Returns the RMS of the output for an input of noise with standard deviation 1.
    static double NoiseLeft(JointPredictor predictor, double ahead)
    {
        const int count = 4000;
        var random = new Random(9);
        var squares = 0.0;
        for (var i = 0; i < count; i++)
        {
            predictor.Add(new JointSample(i * Interval, Math.Sqrt(12) * (random.NextDouble() - 0.5)));
            var shown = predictor.At(i * Interval + ahead).Position;
            if (i > count / 10) squares += shown * shown;
        }
        return Math.Sqrt(squares / (0.9 * count));
    }
}
