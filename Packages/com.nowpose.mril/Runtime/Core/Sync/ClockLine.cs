using System;

namespace Nowpose.Sync
{
    /// <summary>Result of an estimator: Φ as a line over the headset clock, with its statistical uncertainty.</summary>
    readonly struct ClockLine
    {
        /// <summary>
        /// Maximum skew: each of the two quartz clocks is accurate to 100 ppm, and slewing a clock to a reference adds up to 500 ppm.
        /// </summary>
        internal const double MaxSkew = 700e-6;

        /// <summary>Returns the skew of real clocks that is nearest to an estimated skew.</summary>
        internal static double LimitSkew(double skew) => Math.Max(-MaxSkew, Math.Min(MaxSkew, skew));

        /// <summary>Returns the standard error of an estimated skew about which only <see cref="MaxSkew"/> is known.</summary>
        internal static double MaxSkewError(double skew) => (MaxSkew + Math.Abs(skew)) / 3;

        /// <summary>
        /// Returns the standard error of a skew that the server's own error causes. The server's clock may have been wrong by the stated error bound
        /// in the oldest exchange, and by the stated bound in the opposite direction in the newest exchange. A third of the resulting skew is used.
        /// </summary>
        internal static double ServerSkewError(TimeSpan oldestBound, TimeSpan newestBound, TimeSpan span) =>
            (oldestBound + newestBound).Ticks / (3.0 * Math.Max(1, span.Ticks));

        public ClockLine(HeadsetTime reference, ClockOffset offset, double skew, TimeSpan offsetError, double skewError, int exchanges)
        {
            Reference = reference;
            Offset = offset;
            Skew = skew;
            OffsetError = offsetError;
            SkewError = skewError;
            Exchanges = exchanges;
        }

        /// <summary>Headset time of the newest exchange, at which <see cref="Offset"/> applies.</summary>
        public HeadsetTime Reference { get; }

        public ClockOffset Offset { get; }

        /// <summary>Skew γ₂−1; dimensionless.</summary>
        public double Skew { get; }

        /// <summary>Standard error of <see cref="Offset"/>; zero while it is unknown.</summary>
        public TimeSpan OffsetError { get; }

        /// <summary>Standard error of <see cref="Skew"/>; at most <see cref="MaxSkewError"/> while it is unknown.</summary>
        public double SkewError { get; }

        /// <summary>Number of exchanges since the start or the last reset. If it is 0, the other values are undefined.</summary>
        public int Exchanges { get; }

        public ClockOffset OffsetAt(HeadsetTime t) => Offset + ClockTicks.Span(ClockTicks.Seconds(t - Reference) * Skew);

        /// <summary>Returns the standard error of <see cref="OffsetAt"/>, s; it grows quickly for a line through few points.</summary>
        public double ErrorAt(HeadsetTime t)
        {
            var change = SkewError * ClockTicks.Seconds(t - Reference);
            var offset = ClockTicks.Seconds(OffsetError);
            return Math.Sqrt(offset * offset + change * change);
        }
    }
}
