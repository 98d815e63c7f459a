using MathNet.Numerics;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Benchmarks.Competitors;

/// <summary>
/// Schnierle &amp; Röck 2022, Eq. (8), for n = h = 2. A direct implementation that calls MathNet's <c>Fit.Polynomial</c> for each sample.
/// </summary>
sealed class PolynomialFit : Forecaster
{
    const int Degree = 2;

    double _newest;
    double[] _coefficients = [0];

    public override int Samples => Degree + 1;

    public override bool Solve(MotionState motion)
    {
        var ages = Enumerable.Range(0, Math.Min(Samples, motion.Samples.Count)).ToArray();
        var times = ages.Select(age => motion.Samples[age].Time - motion.Samples.NewestTime).ToArray();
        var positions = ages.Select(age => motion.Samples[age].Position).ToArray();
        _coefficients = Fit.Polynomial(times, positions, ages.Length - 1);
        _newest = motion.Samples[0].Position;
        return true;
    }

    public override double At(double ahead) => Polynomial.Evaluate(ahead, _coefficients) - _newest;
}
