using System;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Limits the scored errors, so that one wrong sample does not outweigh seconds of correct ones.</summary>
    /// <remarks>
    /// Starts at eight times the usual error. Errors that stay above it are not outliers, so the threshold grows with each. Without it, a
    /// single glitch or an angle that wraps would dominate the statistics for minutes.
    /// </remarks>
    sealed class OutlierThreshold
    {
        /// <summary>Multiple of hold's usual error: with five, the error on one recording was 6 % larger.</summary>
        const double Tolerance = 8;

        /// <summary>
        /// Factor per error above the threshold. Twelve consecutive errors, more than in any glitch, raise the threshold by a factor of 15.
        /// </summary>
        const double Growth = 1.25;

        double _tolerance = Tolerance;

        /// <summary>Returns the maximum error that is scored now.</summary>
        /// <param name="usual">Root mean square of the usual error.</param>
        public double Of(double usual) => _tolerance * usual;

        /// <summary>Adapts the threshold to an error.</summary>
        /// <param name="usual">As in <see cref="Of"/>.</param>
        /// <param name="error">Maximum of the errors at this moment; not negative.</param>
        public void Add(double usual, double error) =>
            _tolerance = error > Of(usual) ? _tolerance * Growth : Math.Max(Tolerance, _tolerance / Growth);

        public void Reset() => _tolerance = Tolerance;
    }
}
