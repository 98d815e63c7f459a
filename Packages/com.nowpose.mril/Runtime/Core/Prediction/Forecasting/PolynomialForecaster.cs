using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Forecasts by the polynomial of Schnierle &amp; Röck 2022, Eq. (8): interpolating for h = n, least squares for h &gt; n.</summary>
    /// <remarks>
    /// The weight of sample j at time x is the sum of φ(x) φ(t_j) / |φ|² over polynomials φ that are orthogonal on the sample times (Forsythe 1957); unlike
    /// normal equations, this does not square the condition number. For fewer than h + 1 samples, or coinciding times, the degree is the highest that the
    /// samples determine.
    /// </remarks>
    sealed class PolynomialForecaster : LinearSmoother
    {
        /// <summary>Maximum h: limits memory and time per sample. At 100 Hz, the polynomial spans one second.</summary>
        public const int MaxHistory = 100;

        /// <summary>
        /// Maximum n, as in the paper. With stamp errors of ± 5 ms, the error of degree 3 is already 2.5 times that of degree 2 (T_s 50, L 100 ms).
        /// </summary>
        public const int MaxDegree = 3;

        /// <summary>
        /// Minimum ratio of the squared norms of a polynomial and the previous one, divided by the squared norm of the polynomial of degree 1. A
        /// smaller ratio means that times coincide and determine no polynomial.
        /// </summary>
        const double MinNormRatio = 1e-14;

        /// <summary>
        /// Number of orthogonalisations of each polynomial; the second removes the rounding errors of the first, which clustered times amplify.
        /// </summary>
        const int Orthogonalisations = 2;

        readonly int _maxDegree;
        int _degree;

        // _values: for each degree, the values of the orthogonal polynomial at the sample times; a solve finally divides them by the squared norm.
        // _norms: for each degree, the squared norm.
        readonly double[][] _values;
        readonly double[] _norms;

        // The polynomial of degree k is x times that of degree k − 1, minus the sum of the lower polynomials with these coefficients.
        readonly double[][] _coefficients;

        /// <param name="degree">n, 0 to 3.</param>
        /// <param name="history">h, the number of samples used in addition to the newest one; n to 100.</param>
        /// <param name="stopsAtReversal">See <see cref="LinearSmoother"/>.</param>
        public PolynomialForecaster(int degree, int history, bool stopsAtReversal = false) : base(history + 1, stopsAtReversal)
        {
            _maxDegree = degree;
            (_values, _coefficients) = (new double[degree + 1][], new double[degree + 1][]);
            for (var k = 0; k <= degree; k++) (_values[k], _coefficients[k]) = (new double[UsedSamples], new double[k]);
            _norms = new double[degree + 1];
        }

        protected override int MinSamples => 1;

        /// <returns>False if the degree is 0 or the times determine no velocity.</returns>
        protected override bool SolveWeights()
        {
            _degree = 0;
            for (var j = 0; j < Count; j++) _values[0][j] = 1;
            _norms[0] = Count;
            while (_degree < _maxDegree && TryAddPolynomial(_degree + 1)) _degree++;
            for (var k = 0; k <= _degree; k++)
                for (var j = 0; j < Count; j++) _values[k][j] /= _norms[k];
            return _degree > 0;
        }

        // Computes the values of the polynomial of degree k at the sample times. Returns whether they determine it.
        bool TryAddPolynomial(int k)
        {
            var (values, coefficients) = (_values[k], _coefficients[k]);
            for (var j = 0; j < Count; j++) values[j] = Times[j] * _values[k - 1][j];
            Array.Clear(coefficients, 0, k);
            for (var i = 0; i < Orthogonalisations; i++)
                for (var lower = k - 1; lower >= 0; lower--) coefficients[lower] += Orthogonalise(values, lower);
            _norms[k] = Product(values, values);
            return k == 1 ? _norms[1] > 0 : _norms[k] > MinNormRatio * _norms[1] * _norms[k - 1];
        }

        // Subtracts the component of a lower polynomial from the values, and returns its coefficient.
        double Orthogonalise(double[] values, int lower)
        {
            var coefficient = Product(values, _values[lower]) / _norms[lower];
            for (var j = 0; j < Count; j++) values[j] -= coefficient * _values[lower][j];
            return coefficient;
        }

        double Product(double[] one, double[] other)
        {
            var sum = 0.0;
            for (var j = 0; j < Count; j++) sum += one[j] * other[j];
            return sum;
        }

        protected override void FillWeights(double ahead, Span<double> weights)
        {
            Span<double> valuesAtTime = stackalloc double[MaxDegree + 1];
            for (var j = 0; j < Count; j++) weights[j] = _values[0][j];
            valuesAtTime[0] = 1;
            for (var k = 1; k <= _degree; k++)
            {
                var (value, values) = (ahead * valuesAtTime[k - 1], _values[k]);
                for (var lower = 0; lower < k; lower++) value -= _coefficients[k][lower] * valuesAtTime[lower];
                valuesAtTime[k] = value;
                for (var j = 0; j < Count; j++) weights[j] += value * values[j];
            }
        }
    }
}
