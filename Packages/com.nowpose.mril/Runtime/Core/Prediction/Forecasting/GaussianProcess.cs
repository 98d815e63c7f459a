using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Gaussian process regression with a Matérn-7/2 kernel of unit variance and an unknown linear trend: models motion with a continuous
    /// third derivative.
    /// </summary>
    /// <remarks>
    /// k(d) = (1 + r + 2r²/5 + r³/15) e⁻ʳ with r = √7 |d| / l (Rasmussen &amp; Williams 2006, section 4.2.1), plus a constant and a
    /// linear trend of large variance. Ahead of all samples the mean of the process is (A₀ + A₁u + A₂u² + A₃u³) e⁻ᵘ + B₀ + B₁x with
    /// u = √7 x / l, so a solve needs one exponential per sample. Intervals may be uneven.
    /// </remarks>
    sealed class GaussianProcess : Forecaster
    {
        /// <summary>
        /// l, in s: the correlation length of the motion. Among the values from 0.4 to 2 s, this one is best for moves without noise.
        /// </summary>
        const double LengthScale = 0.6;

        /// <summary>Ratio of the variance of the samples' noise to the variance of the motion.</summary>
        const double Noise = 1e-7;

        /// <summary>Number of newest samples used.</summary>
        const int Newest = 5;

        /// <summary>Variance of the level, relative to the variance of the motion.</summary>
        const double LevelVariance = 100;

        /// <summary>
        /// Variance of the trend, relative to the variance of the motion, per second squared: large enough that constant velocity is
        /// predicted exactly.
        /// </summary>
        const double TrendVariance = 1000 / (LengthScale * LengthScale);

        /// <summary>Maximum time between the newest and the oldest used sample, in units of l/√7.</summary>
        const double MaxSpan = 300;

        /// <summary>√7 / l, in 1/s.</summary>
        const double PerSecond = 2.6457513110645906 / LengthScale;

        static readonly double DecayPerStep = Math.Exp(-ForecastTable.Step * PerSecond);

        readonly double[] _times = new double[Newest];
        readonly double[] _decays = new double[Newest];
        readonly double[] _weights = new double[Newest];
        readonly double[] _covariance = new double[Newest];
        readonly double[] _matrix = new double[Newest * Newest];
        double _a0, _a1, _a2, _a3, _b0, _b1;
        int _direction;

        public override int Samples => Newest;

        public override bool Solve(MotionState motion) => Solve(motion, 0);

        /// <summary>Solves as if an earlier sample were the newest. The results are relative to this sample until the next solve.</summary>
        /// <param name="age">Number of newer samples, which are ignored.</param>
        /// <inheritdoc cref="Solve(MotionState)"/>
        public bool Solve(MotionState motion, int age)
        {
            if (motion.ConnectedSamples < age + Newest) return false;
            ref readonly var newest = ref motion.Samples[age];
            // The exponentials of samples this far apart are zero to rounding.
            if ((newest.Time - motion.Samples[age + Newest - 1].Time) * PerSecond > MaxSpan) return false;
            for (var i = 0; i < Newest; i++)
            {
                ref readonly var sample = ref motion.Samples[age + i];
                _times[i] = sample.Time - newest.Time;
                _decays[i] = i == 0 ? 1 : Math.Exp(_times[i] * PerSecond);
                _weights[i] = sample.Position - newest.Position;
            }
            FillMatrix();
            Cholesky.Factor(_matrix, Newest);
            Cholesky.Solve(_matrix, _weights, Newest);
            Sum();
            _direction = Math.Sign(newest.Position - motion.Samples[age + 1].Position);
            return true;
        }

        public override double At(double ahead) => At(ahead, Math.Exp(-ahead * PerSecond));

        /// <summary>Returns the variance of the position, relative to the variance of the motion about its trend.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        public double VarianceAt(double ahead)
        {
            var decay = Math.Exp(-ahead * PerSecond);
            for (var i = 0; i < Newest; i++)
                _covariance[i] = Polynomial((ahead - _times[i]) * PerSecond) * decay * _decays[i]
                    + LevelVariance + TrendVariance * ahead * _times[i];
            Cholesky.SolveLower(_matrix, _covariance, Newest);
            var variance = 1 + LevelVariance + TrendVariance * ahead * ahead;
            foreach (var part in _covariance) variance -= part * part;
            return Math.Max(variance, 0);
        }

        /// <summary>
        /// Fills the table like the base method, but keeps the forecast constant after a reversal, because drives stop far more often than they
        /// reverse. Only the mixture uses tables; the predictor <c>gp</c> reads <see cref="At(double)"/>, which continues after a reversal.
        /// </summary>
        /// <inheritdoc/>
        public override void Fill(double[] table, int start, int points)
        {
            var (ahead, decay, position, direction) = (0.0, 1.0, At(0, 1), _direction);
            table[start] = position;
            for (var i = start + 1; i < start + points; i++)
            {
                ahead += ForecastTable.Step;
                decay *= DecayPerStep;
                var next = At(ahead, decay);
                if ((next - position) * direction > 0) position = next;
                else direction = 0;
                table[i] = position;
            }
        }

        void FillMatrix()
        {
            var (matrix, times, decays) = (_matrix, _times, _decays);
            for (var i = 0; i < Newest; i++)
            {
                var (time, decay, trend, row) = (times[i], decays[i], TrendVariance * times[i], i * Newest);
                for (var j = 0; j < i; j++)
                {
                    var r = (times[j] - time) * PerSecond;
                    matrix[row + j] = Polynomial(r) * decay / decays[j] + LevelVariance + trend * times[j];
                }
                matrix[row + i] = 1 + LevelVariance + trend * time + Noise;
            }
        }

        // k without its exponential; r is never negative, because the newest sample comes first.
        static double Polynomial(double r) => 1 + r * (1 + r * (0.4 + r / 15));

        // Returns the forecast x seconds after the newest sample. The argument decay is e⁻ᵘ, with u as below.
        double At(double x, double decay)
        {
            var u = x * PerSecond;
            return (_a0 + u * (_a1 + u * (_a2 + u * _a3))) * decay + _b0 + _b1 * x;
        }

        // Sums the kernels of all samples, expanded in powers of u.
        void Sum()
        {
            _a0 = _a1 = _a2 = _a3 = _b0 = _b1 = 0;
            for (var i = 0; i < Newest; i++)
            {
                var weight = _weights[i] * _decays[i];
                var v = -_times[i] * PerSecond;
                _a0 += weight * Polynomial(v);
                _a1 += weight * (1 + v * (0.8 + 0.2 * v));
                _a2 += weight * (0.4 + 0.2 * v);
                _a3 += weight / 15;
                _b0 += LevelVariance * _weights[i];
                _b1 += TrendVariance * _times[i] * _weights[i];
            }
        }
    }
}
