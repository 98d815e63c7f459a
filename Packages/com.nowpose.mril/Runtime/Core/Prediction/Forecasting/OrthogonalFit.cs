namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Fits the polynomial of Eq. (8) by ordinary least squares if there are more points than coefficients.</summary>
    /// <remarks>
    /// The basis consists of polynomials that are orthogonal on the sample times, from a three-term recurrence (Forsythe 1957), so the
    /// solve needs no matrix and does not square the condition number as normal equations do.
    /// </remarks>
    sealed class OrthogonalFit
    {
        // Values at the sample times, and coefficients, of the newest polynomial of the basis and of the previous polynomial.
        double[] _values, _valuesBefore;
        double[] _powers = new double[PolynomialForecaster.MaxDegree + 1], _powersBefore = new double[PolynomialForecaster.MaxDegree + 1];

        public OrthogonalFit(int points) => (_values, _valuesBefore) = (new double[points], new double[points]);

        /// <summary>
        /// Adds the fit of the first <paramref name="count"/> points to the coefficients, the constant first. Overwrites the
        /// positions with the residuals; needs more distinct times than the degree.
        /// </summary>
        public void Solve(double[] times, double[] positions, int count, int degree, double[] coefficients)
        {
            for (var i = 0; i < count; i++) (_values[i], _valuesBefore[i]) = (1, 0);
            for (var k = 0; k < _powers.Length; k++) _powers[k] = _powersBefore[k] = 0;
            _powers[0] = 1;
            double norm = count, normBefore = double.PositiveInfinity;
            for (var j = 0; ; j++)
            {
                Project(positions, count, norm, coefficients);
                if (j == degree) return;
                normBefore = Next(times, count, norm, norm / normBefore);
                (norm, normBefore) = (normBefore, norm);
            }
        }

        // Projects the positions onto the newest polynomial, adds the result to the fit, and leaves the residuals.
        void Project(double[] positions, int count, double norm, double[] coefficients)
        {
            var (values, powers, coefficient) = (_values, _powers, 0.0);
            for (var i = 0; i < count; i++) coefficient += positions[i] * values[i];
            coefficient /= norm;
            for (var i = 0; i < count; i++) positions[i] -= coefficient * values[i];
            for (var k = 0; k < powers.Length; k++) coefficients[k] += coefficient * powers[k];
        }

        // Replaces the previous polynomial with the next one. Returns its squared norm.
        double Next(double[] times, int count, double norm, double ratio)
        {
            var square = Next(times, count, _values, _valuesBefore, norm, ratio, _valuesBefore, out var centre);
            var (powers, nextPowers) = (_powers, _powersBefore);
            for (var k = 0; k < powers.Length; k++) nextPowers[k] = (k > 0 ? powers[k - 1] : 0) - centre * powers[k] - ratio * nextPowers[k];
            (_values, _valuesBefore, _powers, _powersBefore) = (_valuesBefore, _values, nextPowers, powers);
            return square;
        }

        /// <summary>Computes the next orthogonal polynomial, (t − centre) · newest − ratio · previous, at the sample times.</summary>
        /// <param name="norm">Squared norm of the newest polynomial.</param>
        /// <param name="ratio">This norm relative to that of the previous polynomial; 0 for the polynomial of degree 1.</param>
        /// <param name="next">Receives the values; may be the array of the previous polynomial.</param>
        /// <returns>The squared norm of the next polynomial.</returns>
        public static double Next(
            double[] times, int count, double[] newest, double[] previous, double norm, double ratio, double[] next, out double centre)
        {
            var square = 0.0;
            centre = 0;
            for (var i = 0; i < count; i++) centre += times[i] * newest[i] * newest[i];
            centre /= norm;
            for (var i = 0; i < count; i++)
            {
                var value = (times[i] - centre) * newest[i] - ratio * previous[i];
                next[i] = value;
                square += value * value;
            }
            return square;
        }
    }
}
