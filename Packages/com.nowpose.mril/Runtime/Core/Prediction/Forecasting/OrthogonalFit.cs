using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Ordinary least squares for Eq. (8) with more points than coefficients.</summary>
    /// <remarks>
    /// The basis is orthogonalised on the sample times, each power from the one before, so the solve needs no
    /// matrix and does not square the condition number as normal equations do.
    /// </remarks>
    sealed class OrthogonalFit
    {
        /// <summary>
        /// Threshold of a second pass, which removes the rounding errors of the first. It is needed only for clustered stamps, where the first
        /// pass removes nearly everything: ratio of the squared norm after the first pass to that before.
        /// </summary>
        const double NearlyAll = 0.01;

        readonly double[][] _values;
        readonly double[][] _powers;

        public OrthogonalFit(int degree, int points)
        {
            _values = new double[degree + 1][];
            _powers = new double[degree + 1][];
            for (var j = 0; j <= degree; j++)
            {
                _values[j] = new double[points];
                _powers[j] = new double[degree + 1];
            }
        }

        /// <summary>
        /// Adds the fit of the first <paramref name="count"/> points to the coefficients, the constant first. Overwrites the
        /// positions with the residuals; needs more distinct times than the degree.
        /// </summary>
        public void Solve(double[] times, double[] positions, int count, int degree, double[] coefficients)
        {
            for (var j = 0; j <= degree; j++)
            {
                MakeNext(j, times, count, degree);
                var before = Dot(_values[j], _values[j], count);
                RemoveOthers(j, count, degree);
                if (Dot(_values[j], _values[j], count) < NearlyAll * before) RemoveOthers(j, count, degree);
                Normalise(j, count, degree);

                var (values, powers) = (_values[j], _powers[j]);
                var share = Dot(values, positions, count);
                for (var i = 0; i < count; i++) positions[i] -= share * values[i];
                for (var k = 0; k <= degree; k++) coefficients[k] += share * powers[k];
            }
        }

        void MakeNext(int j, double[] times, int count, int degree)
        {
            if (j == 0)
            {
                Array.Clear(_powers[0], 0, degree + 1);
                _powers[0][0] = 1;
                for (var i = 0; i < count; i++) _values[0][i] = 1;
                return;
            }
            var (values, powers, valuesBefore, powersBefore) = (_values[j], _powers[j], _values[j - 1], _powers[j - 1]);
            for (var i = 0; i < count; i++) values[i] = times[i] * valuesBefore[i];
            for (var k = degree; k > 0; k--) powers[k] = powersBefore[k - 1];
            powers[0] = 0;
        }

        void RemoveOthers(int j, int count, int degree)
        {
            for (var other = 0; other < j; other++) RemoveFrom(j, other, count, degree);
        }

        void RemoveFrom(int j, int other, int count, int degree)
        {
            var (values, powers, otherValues, otherPowers) = (_values[j], _powers[j], _values[other], _powers[other]);
            var share = Dot(values, otherValues, count);
            for (var i = 0; i < count; i++) values[i] -= share * otherValues[i];
            for (var k = 0; k <= degree; k++) powers[k] -= share * otherPowers[k];
        }

        void Normalise(int j, int count, int degree)
        {
            var (values, powers) = (_values[j], _powers[j]);
            var perLength = 1 / Math.Sqrt(Dot(values, values, count));
            for (var i = 0; i < count; i++) values[i] *= perLength;
            for (var k = 0; k <= degree; k++) powers[k] *= perLength;
        }

        static double Dot(double[] a, double[] b, int count)
        {
            var sum = 0.0;
            for (var i = 0; i < count; i++) sum += a[i] * b[i];
            return sum;
        }
    }
}
