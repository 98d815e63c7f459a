using System;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Limits the errors that are scored, so that one wrong sample does not outweigh seconds of right ones.</summary>
    /// <remarks>
    /// Eight times the usual, at first; errors that stay beyond it are not outliers, and the threshold grows with each. Without it a
    /// single glitch, or an angle that wraps, would be all that is remembered for minutes.
    /// </remarks>
    sealed class OutlierThreshold
    {
        /// <summary>In usual errors of hold: with five a recording erred 6 % more.</summary>
        const double Tolerance = 8;

        /// <summary>Per error beyond the bound: a dozen in a row, which no glitch makes, are credited fifteenfold.</summary>
        const double Growth = 1.25;

        double _tolerance = Tolerance;

        /// <summary>The greatest error credited now.</summary>
        /// <param name="usual">Root mean square of what is usual.</param>
        public double Of(double usual) => _tolerance * usual;

        /// <summary>Takes an error that is learned from.</summary>
        /// <param name="usual">As in <see cref="Of"/>.</param>
        /// <param name="error">Greatest of the errors at this moment; not negative.</param>
        public void Add(double usual, double error) =>
            _tolerance = error > Of(usual) ? _tolerance * Growth : Math.Max(Tolerance, _tolerance / Growth);

        public void Reset() => _tolerance = Tolerance;
    }
}
