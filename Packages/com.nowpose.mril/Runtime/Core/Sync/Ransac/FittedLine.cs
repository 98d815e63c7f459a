using System;
using MathNet.Numerics.LinearRegression;
using MathNet.Numerics.Statistics;

namespace Nowpose.Sync.Ransac
{
    /// <summary>Fits a least-squares line to offsets over the headset clock, Eq. (6).</summary>
    static class FittedLine
    {
        /// <param name="x">Seconds relative to <paramref name="reference"/>; at least two values that are not all equal.</param>
        /// <param name="y">Seconds relative to <paramref name="referenceOffset"/>.</param>
        /// <param name="bound">Maximum distance of a point from the line, s.</param>
        /// <param name="exchanges">Number of exchanges since the start or the last reset.</param>
        public static ClockLine Through(
            double[] x, double[] y, HeadsetTime reference, ClockOffset referenceOffset, double bound, int exchanges)
        {
            var (intercept, slope) = SimpleRegression.Fit(x, y);
            var meanX = ArrayStatistics.Mean(x);
            double squares = 0, spread = 0;
            for (var i = 0; i < x.Length; i++)
            {
                var residual = y[i] - intercept - slope * x[i];
                squares += residual * residual;
                spread += (x[i] - meanX) * (x[i] - meanX);
            }
            // Includes one virtual point at the maximum distance, because the residuals of a line through two points are always zero.
            var variance = (squares + bound * bound) / (x.Length - 1);
            var offsetError = Math.Sqrt(variance * (1.0 / x.Length + meanX * meanX / spread));
            return new ClockLine(
                reference, referenceOffset + ClockTicks.Span(intercept), slope,
                ClockTicks.Span(offsetError), Math.Sqrt(variance / spread), exchanges);
        }
    }
}
