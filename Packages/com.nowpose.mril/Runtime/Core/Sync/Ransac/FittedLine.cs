using System;
using MathNet.Numerics.LinearRegression;

namespace Nowpose.Sync.Ransac
{
    /// <summary>Least-squares line through offsets over the headset clock, Eq. (6), relative to a reference time.</summary>
    readonly struct FittedLine
    {
        FittedLine(HeadsetTime reference, ClockOffset offset, double skew, TimeSpan offsetError, double skewError)
        {
            Reference = reference;
            Offset = offset;
            Skew = skew;
            OffsetError = offsetError;
            SkewError = skewError;
        }

        public HeadsetTime Reference { get; }
        public ClockOffset Offset { get; }
        public double Skew { get; }
        public TimeSpan OffsetError { get; }
        public double SkewError { get; }

        public ClockOffset OffsetAt(HeadsetTime t) => Offset + ClockTicks.Span(ClockTicks.Seconds(t - Reference) * Skew);

        /// <summary>Returns the standard error of <see cref="OffsetAt"/>, s; it grows quickly for a line through few points.</summary>
        public double ErrorAt(HeadsetTime t)
        {
            var change = SkewError * ClockTicks.Seconds(t - Reference);
            var offset = ClockTicks.Seconds(OffsetError);
            return Math.Sqrt(offset * offset + change * change);
        }

        /// <param name="x">Seconds relative to <paramref name="reference"/>; at least two values that are not all equal.</param>
        /// <param name="y">Seconds relative to <paramref name="referenceOffset"/>.</param>
        /// <param name="bound">Maximum distance of a point from the line, s.</param>
        public static FittedLine Through(double[] x, double[] y, HeadsetTime reference, ClockOffset referenceOffset, double bound)
        {
            var (intercept, slope) = SimpleRegression.Fit(x, y);
            var meanX = Mean(x);
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
            return new FittedLine(
                reference, referenceOffset + ClockTicks.Span(intercept), slope,
                ClockTicks.Span(offsetError), Math.Sqrt(variance / spread));
        }

        static double Mean(double[] values)
        {
            double sum = 0;
            foreach (var value in values) sum += value;
            return sum / values.Length;
        }
    }
}
