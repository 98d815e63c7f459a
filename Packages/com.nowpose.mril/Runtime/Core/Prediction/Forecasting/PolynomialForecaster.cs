using System;
using Nowpose.Messages;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Section-wise polynomials of Schnierle &amp; Röck 2022, Eq. (8): interpolating for h = n, least squares for h &gt; n.
    /// </summary>
    /// <remarks>
    /// For fewer than h + 1 samples, or coinciding stamps, it uses the highest degree that they determine. Degree 0 is hold.
    /// Times are relative to the newest sample and scaled by a power of two near the window's span; positions are relative to
    /// the newest one. Thus neither the epoch nor the unit affects the accuracy, and the scaling causes no rounding.
    /// </remarks>
    sealed class PolynomialForecaster : Forecaster
    {
        /// <summary>Maximum h.</summary>
        public const int MaxHistory = 100;

        public const int MaxDegree = 3;

        /// <summary>
        /// Minimum interval between distinct stamps, s: half a tick of the time types. Closer stamps count as equal, because no polynomial can pass
        /// through both samples.
        /// </summary>
        const double CoincidentSeconds = 0.5e-7;

        readonly int _degree;
        readonly double[] _times;
        readonly double[] _positions;
        readonly double[] _coefficients = new double[MaxDegree + 1];
        readonly OrthogonalFit _fit;
        double _perScale;

        /// <param name="degree">n, 0 to 3.</param>
        /// <param name="history">h, the number of samples used in addition to the newest one; n to 100.</param>
        /// <exception cref="ArgumentOutOfRangeException">Degree or history is outside its range.</exception>
        public PolynomialForecaster(int degree, int history)
        {
            if (degree < 0 || degree > MaxDegree)
                throw new ArgumentOutOfRangeException(nameof(degree), degree, "0 to " + MaxDegree);
            if (history < degree || history > MaxHistory)
                throw new ArgumentOutOfRangeException(nameof(history), history, PredictionMessages.History(MaxHistory));
            _degree = degree;
            Samples = history + 1;
            _times = new double[Samples];
            _positions = new double[Samples];
            _fit = new OrthogonalFit(Samples);
        }

        public override int Samples { get; }

        /// <returns>False if the degree is 0 or the stamps determine no velocity; the position is then held.</returns>
        public override bool Solve(MotionState motion)
        {
            var count = Math.Min(motion.ConnectedSamples, Samples);
            Array.Clear(_coefficients, 0, _coefficients.Length);
            Localise(motion.Samples, count);
            var degree = Math.Min(_degree, DistinctTimes(count) - 1);
            if (degree == 0) return false;
            if (count == degree + 1) Interpolate(degree);
            else _fit.Solve(_times, _positions, count, degree, _coefficients);
            return true;
        }

        public override double At(double ahead)
        {
            var x = ahead * _perScale;
            var c = _coefficients;
            return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
        }

        public override void Fill(double[] table, int start, int points)
        {
            var (c0, c1, c2, c3) = (_coefficients[0], _coefficients[1], _coefficients[2], _coefficients[3]);
            var step = ForecastTable.Step * _perScale;
            var x = 0.0;
            for (var i = start; i < start + points; i++, x += step) table[i] = c0 + x * (c1 + x * (c2 + x * c3));
        }

        void Localise(SampleHistory history, int count)
        {
            var span = 0.0;
            var (newestTime, newestPosition) = (history.NewestTime, history.NewestPosition);
            for (var i = 0; i < count; i++)
            {
                ref readonly var sample = ref history[i];
                var time = sample.Time - newestTime;
                _times[i] = time;
                _positions[i] = sample.Position - newestPosition;
                if (time < 0) time = -time;
                if (time > span) span = time;
            }
            _perScale = span > 0 ? 1 / PowerOfTwoBelow(span) : 1;
            for (var i = 0; i < count; i++) _times[i] *= _perScale;
        }

        int DistinctTimes(int count)
        {
            var coincident = CoincidentSeconds * _perScale;
            var distinct = count;
            var earliest = _times[0];
            for (var i = 1; i < count; i++)
            {
                // Sorted stamps need only one comparison each.
                if (_times[i] <= earliest - coincident)
                {
                    earliest = _times[i];
                    continue;
                }
                for (var j = 0; j < i; j++)
                    if (Math.Abs(_times[i] - _times[j]) < coincident)
                    {
                        distinct--;
                        break;
                    }
            }
            return distinct;
        }

        // Newton's divided differences, the most accurate method for clustered stamps, expanded for Horner's scheme.
        void Interpolate(int degree)
        {
            var differences = _positions;
            for (var level = 1; level <= degree; level++)
                for (var i = degree; i >= level; i--)
                    differences[i] = (differences[i] - differences[i - 1]) / (_times[i] - _times[i - level]);

            for (var i = degree; i >= 0; i--)
            {
                for (var k = degree; k > 0; k--) _coefficients[k] = _coefficients[k - 1] - _times[i] * _coefficients[k];
                _coefficients[0] = differences[i] - _times[i] * _coefficients[0];
            }
        }

        static double PowerOfTwoBelow(double value) =>
            BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(value) & 0x7FF0_0000_0000_0000);
    }
}
