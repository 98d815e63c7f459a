using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Weights of the polynomial of Schnierle &amp; Röck 2022, Eq. (8): interpolating for h = n, least squares for h &gt; n.</summary>
    /// <remarks>
    /// The weight of sample j at time x is the sum of φ(x) φ(t_j) / |φ|² over the polynomials φ that are orthogonal on the sample times
    /// (<see cref="OrthogonalFit"/>). Unlike <see cref="PolynomialForecaster"/>, it needs all h + 1 samples, and samples less than a millisecond
    /// apart reduce its precision.
    /// </remarks>
    sealed class PolynomialWeights : PositionWeights
    {
        /// <summary>
        /// Minimum ratio of the squared norms of a polynomial and the previous one, divided by the squared norm of the polynomial of degree 1. A
        /// smaller ratio means that times coincide and determine no polynomial.
        /// </summary>
        const double MinNormRatio = 1e-14;

        readonly int _degree;

        // _values: for each degree, the values of the polynomial at the sample times; a solve finally divides them by the squared norm. _norms: for
        // each degree, the squared norm.
        readonly double[][] _values;
        readonly double[] _norms;

        // Coefficients of the recurrence: the next polynomial is (x − centre) · newest − ratio · previous.
        readonly double[] _centres, _ratios;

        /// <param name="degree">n, 1 or more.</param>
        /// <param name="history">h, the number of samples used in addition to the newest one; n or more.</param>
        public PolynomialWeights(int degree, int history) : base(history + 1)
        {
            _degree = degree;
            _values = new double[degree + 1][];
            for (var k = 0; k <= degree; k++) _values[k] = new double[Samples];
            (_norms, _centres, _ratios) = (new double[degree + 1], new double[degree + 1], new double[degree + 1]);
        }

        public override void At(double ahead, double[] weights, int start)
        {
            var (newest, previous) = (1.0, 0.0);
            for (var j = 0; j < Samples; j++) weights[start + j] = _values[0][j];
            for (var k = 1; k <= _degree; k++)
            {
                (newest, previous) = ((ahead - _centres[k]) * newest - _ratios[k] * previous, newest);
                var values = _values[k];
                for (var j = 0; j < values.Length; j++) weights[start + j] += newest * values[j];
            }
        }

        protected override bool Solve()
        {
            for (var j = 0; j < Samples; j++) _values[0][j] = 1;
            _norms[0] = Samples;
            for (var k = 1; k <= _degree; k++)
            {
                _ratios[k] = k > 1 ? _norms[k - 1] / _norms[k - 2] : 0;
                _norms[k] = OrthogonalFit.Next(
                    Times, Samples, _values[k - 1], _values[Math.Max(0, k - 2)], _norms[k - 1], _ratios[k], _values[k], out _centres[k]);
                if (!(_norms[k] > MinNormRatio * _norms[1] * _norms[k - 1])) return false;
            }
            for (var k = 0; k <= _degree; k++)
                for (var j = 0; j < Samples; j++) _values[k][j] /= _norms[k];
            return true;
        }
    }
}
