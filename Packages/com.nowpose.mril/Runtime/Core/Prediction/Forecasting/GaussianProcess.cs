using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Gaussian process regression with a Matérn-7/2 kernel of unit variance and an unknown linear trend: models motion with a continuous
    /// third derivative.
    /// </summary>
    /// <remarks>
    /// k(d) = (1 + r + 2r²/5 + r³/15) e⁻ʳ with r = √7 |d| / l (Rasmussen &amp; Williams 2006, section 4.2.1), plus a constant and a
    /// linear trend of large variance. The mean at a given time is the weighted sum of the samples' positions with the weights K⁻¹k, where K is the
    /// covariance of the samples and k their covariance with the position at that time (Eq. 2.25 there). Intervals may be uneven.
    /// </remarks>
    sealed class GaussianProcess : LinearSmoother
    {
        /// <summary>
        /// l, in s: the correlation length of the motion. Among the values from 0.4 to 2 s, this one is best for moves without noise. With 0.4 s, the
        /// errors on recordings are 1.0 % larger; with 0.9 s, those of simulated motions 1.5 %.
        /// </summary>
        const double LengthScale = 0.6;

        /// <summary>
        /// Ratio of the variance of the samples' noise to the variance of the motion. With 1e-8, the errors on recordings are 0.6 % larger; with
        /// 1e-6, those of simulated motions 1.4 %.
        /// </summary>
        const double Noise = 1e-7;

        /// <summary>Number of newest samples used. With 4, the errors are 0.6 to 1.0 % larger; with 7, up to 0.4 %.</summary>
        const int SampleCount = 5;

        /// <summary>
        /// Variance of the level, relative to the variance of the motion, and of the trend over one length scale: large, because both are unknown, so
        /// that constant velocity is predicted exactly. With a level of 10 or 100, the errors change by less than 0.1 %.
        /// </summary>
        const double LevelVariance = 1000, TrendVariance = LevelVariance / (LengthScale * LengthScale);

        /// <summary>Maximum time between the newest and the oldest used sample, in units of l/√7.</summary>
        const double MaxSpan = 300;

        /// <summary>√7 / l, in 1/s.</summary>
        const double PerSecond = 2.6457513110645906 / LengthScale;

        readonly double[] _decays = new double[SampleCount];
        readonly double[] _matrix = new double[SampleCount * SampleCount];

        /// <param name="stopsAtReversal">See <see cref="LinearSmoother"/>.</param>
        public GaussianProcess(bool stopsAtReversal = false) : base(SampleCount, stopsAtReversal) { }

        /// <summary>Returns the variance of the position, relative to the variance of the motion about its trend.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        public double VarianceAt(double ahead)
        {
            Span<double> covariance = stackalloc double[SampleCount];
            FillCovariance(ahead, covariance);
            Cholesky.SolveLower(_matrix, covariance);
            var variance = 1 + LevelVariance + TrendVariance * ahead * ahead;
            foreach (var part in covariance) variance -= part * part;
            return Math.Max(variance, 0);
        }

        protected override void FillWeights(double ahead, Span<double> weights)
        {
            FillCovariance(ahead, weights);
            Cholesky.Solve(_matrix, weights);
        }

        protected override bool SolveWeights()
        {
            // The exponentials of samples this far apart are zero to rounding.
            if (-Times[SampleCount - 1] * PerSecond > MaxSpan) return false;
            var (matrix, times, decays) = (_matrix, Times, _decays);
            for (var i = 0; i < SampleCount; i++)
            {
                var (time, trend, row) = (times[i], TrendVariance * times[i], i * SampleCount);
                decays[i] = Math.Exp(time * PerSecond);
                for (var j = 0; j < i; j++)
                    matrix[row + j] = Polynomial((times[j] - time) * PerSecond) * decays[i] / decays[j] + LevelVariance + trend * times[j];
                matrix[row + i] = 1 + LevelVariance + trend * time + Noise;
            }
            Cholesky.Factor(matrix, SampleCount);
            return true;
        }

        // Computes the covariance between the position at a given time and the samples.
        void FillCovariance(double ahead, Span<double> covariance)
        {
            var decay = Math.Exp(-ahead * PerSecond);
            for (var i = 0; i < SampleCount; i++)
                covariance[i] = Polynomial((ahead - Times[i]) * PerSecond) * decay * _decays[i]
                    + LevelVariance + TrendVariance * ahead * Times[i];
        }

        // k without its exponential; r is never negative, because the newest sample comes first.
        static double Polynomial(double r) => 1 + r * (1 + r * (0.4 + r / 15));
    }

    /// <summary>Solves small symmetric positive definite systems in place; unlike MathNet's solver it does not allocate.</summary>
    static class Cholesky
    {
        /// <summary>Pivots below this are rounding errors of an exactly singular system.</summary>
        const double MinPivot = 1e-12;

        /// <param name="matrix">
        /// Row-major n×n matrix. Only its lower triangle is read. Receives the factor L with the reciprocals of its diagonal elements, because
        /// multiplications take less time than divisions.
        /// </param>
        public static void Factor(double[] matrix, int n)
        {
            for (var i = 0; i < n; i++)
            {
                var row = i * n;
                for (var j = 0; j <= i; j++)
                {
                    var other = j * n;
                    var sum = matrix[row + j];
                    for (var k = 0; k < j; k++) sum -= matrix[row + k] * matrix[other + k];
                    matrix[row + j] = i == j ? 1 / Math.Sqrt(sum > MinPivot ? sum : MinPivot) : sum * matrix[other + j];
                }
            }
        }

        /// <summary>Solves A x = vector, where A is the factored matrix.</summary>
        /// <param name="matrix">Result of <see cref="Factor"/>.</param>
        /// <param name="vector">Right-hand side. Receives the solution.</param>
        public static void Solve(double[] matrix, Span<double> vector)
        {
            SolveLower(matrix, vector);
            var n = vector.Length;
            for (var i = n - 1; i >= 0; i--)
            {
                var value = vector[i];
                for (int k = i + 1, at = k * n + i; k < n; k++, at += n) value -= matrix[at] * vector[k];
                vector[i] = value * matrix[i * n + i];
            }
        }

        /// <summary>Solves L x = vector. The sum of the squares of x equals vectorᵀ A⁻¹ vector.</summary>
        /// <inheritdoc cref="Solve"/>
        public static void SolveLower(double[] matrix, Span<double> vector)
        {
            for (int i = 0, row = 0; i < vector.Length; i++, row += vector.Length)
            {
                var value = vector[i];
                for (var k = 0; k < i; k++) value -= matrix[row + k] * vector[k];
                vector[i] = value * matrix[row + i];
            }
        }
    }
}
