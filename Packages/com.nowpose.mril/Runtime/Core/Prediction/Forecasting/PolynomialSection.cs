using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>One section of Schnierle &amp; Röck 2022, Eq. (8): the polynomial that is valid until the next sample.</summary>
    /// <remarks>
    /// Times are relative to the newest sample and scaled by a power of two near the window's span; positions are relative to
    /// the newest one. So neither the epoch nor the unit affects the accuracy, and the scaling causes no rounding.
    /// </remarks>
    sealed class PolynomialSection
    {
        /// <summary>Half a tick of the time types: closer stamps count as equal, and a polynomial cannot pass through both.</summary>
        const double CoincidentSeconds = 0.5e-7;

        public const int HighestDegree = 3;

        readonly int _degree;
        readonly double[] _times;
        readonly double[] _positions;
        readonly double[] _coefficients;
        readonly OrthogonalFit _fit;
        double _perScale;

        public PolynomialSection(int degree, int points)
        {
            _degree = degree;
            _times = new double[points];
            _positions = new double[points];
            _coefficients = new double[HighestDegree + 1];
            _fit = new OrthogonalFit(points);
        }

        /// <summary>Degree of the section in use; 0 if the stamps determine no velocity.</summary>
        public int Degree { get; private set; }

        /// <summary>Returns the position relative to the newest sample's, at a number of seconds after it.</summary>
        public double At(double ahead)
        {
            var x = ahead * _perScale;
            var c = _coefficients;
            return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
        }

        /// <inheritdoc cref="Forecaster.Fill"/>
        public void Fill(double[] table, int start, int points)
        {
            var (c0, c1, c2, c3) = (_coefficients[0], _coefficients[1], _coefficients[2], _coefficients[3]);
            var step = ForecastTable.Step * _perScale;
            var x = 0.0;
            for (var i = start; i < start + points; i++, x += step) table[i] = c0 + x * (c1 + x * (c2 + x * c3));
        }

        /// <summary>Solves for the newest <paramref name="count"/> samples, with the highest degree that they determine.</summary>
        public void Solve(SampleHistory history, int count)
        {
            Array.Clear(_coefficients, 0, _coefficients.Length);
            Localise(history, count);
            Degree = Math.Min(_degree, DistinctTimes(count) - 1);
            if (Degree == 0) return;
            if (count == Degree + 1) Interpolate();
            else _fit.Solve(_times, _positions, count, Degree, _coefficients);
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

        /// <summary>
        /// Interpolates by Newton's divided differences, the most accurate method for clustered stamps, and expands the result for Horner's
        /// scheme.
        /// </summary>
        void Interpolate()
        {
            var differences = _positions;
            for (var level = 1; level <= Degree; level++)
                for (var i = Degree; i >= level; i--)
                    differences[i] = (differences[i] - differences[i - 1]) / (_times[i] - _times[i - level]);

            for (var i = Degree; i >= 0; i--)
            {
                for (var k = Degree; k > 0; k--) _coefficients[k] = _coefficients[k - 1] - _times[i] * _coefficients[k];
                _coefficients[0] = differences[i] - _times[i] * _coefficients[0];
            }
        }

        static double PowerOfTwoBelow(double value)
        {
            const long exponentBits = 0x7FF0_0000_0000_0000;
            return BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(value) & exponentBits);
        }
    }
}
