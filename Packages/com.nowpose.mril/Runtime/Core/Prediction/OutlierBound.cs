using System;

namespace Nowpose.Prediction
{
    /// <summary>How much of an error is credited, so that one wrong sample does not outweigh seconds of right ones.</summary>
    /// <remarks>
    /// Eight times the usual, at first; errors beyond it that go on are no outliers, and the bound grows with each. Without it a
    /// single glitch, or an angle that wraps, would be all that is remembered for minutes.
    /// </remarks>
    sealed class OutlierBound
    {
        const double Tolerance = 8;

        /// <summary>Per error beyond the bound: a dozen in a row, which no glitch makes, are credited fifteenfold.</summary>
        const double Growth = 1.25;

        double _tolerance = Tolerance;

        /// <summary>The greatest error credited now.</summary>
        /// <param name="usual">Root mean square of what is usual.</param>
        /// <param name="error">Greatest of the errors at this moment; not negative.</param>
        public double Of(double usual, double error)
        {
            var bound = _tolerance * usual;
            _tolerance = error > bound ? _tolerance * Growth : Math.Max(Tolerance, _tolerance / Growth);
            return bound;
        }

        public void Reset() => _tolerance = Tolerance;
    }
}
