using MathNet.Numerics;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Benchmarks.Competitors;

/// <summary>
/// Schnierle &amp; Röck 2022, Eq. (8), for n = h = 2. A direct implementation that calls MathNet's <c>Fit.Polynomial</c> for each sample.
/// </summary>
sealed class PolynomialFit : Forecaster
{
    const int Degree = 2;

    double[] _coefficients = [0];

    public override int UsedSamples => Degree + 1;

    public override bool Solve(MotionState motion)
    {
        var count = Math.Min(UsedSamples, motion.Count);
        _coefficients = Fit.Polynomial(motion.Times[..count], motion.Displacements[..count], count - 1);
        return true;
    }

    public override double At(double ahead, int component) => Polynomial.Evaluate(ahead, _coefficients);
}
