using System;

namespace Nowpose.Sync
{
    /// <summary>What an estimator believes: Φ as a line over the headset clock, with its statistical uncertainty.</summary>
    readonly struct ClockLine
    {
        /// <summary>
        /// Two rates differ by no more: quartzes are good to 100 ppm each, and one that is slewed to a reference runs up to
        /// 500 ppm fast or slow beside.
        /// </summary>
        internal const double GreatestSkew = 700e-6;

        public ClockLine(HeadsetTime reference, ClockOffset offset, double skew, TimeSpan offsetError, double skewError, int exchanges)
        {
            Reference = reference;
            Offset = offset;
            Skew = skew;
            OffsetError = offsetError;
            SkewError = skewError;
            Exchanges = exchanges;
        }

        /// <summary>Headset time of the newest exchange, at which <see cref="Offset"/> holds.</summary>
        public HeadsetTime Reference { get; }

        public ClockOffset Offset { get; }

        /// <summary>γ₂−1, dimensionless.</summary>
        public double Skew { get; }

        /// <summary>One standard error of <see cref="Offset"/>; zero while it cannot be told.</summary>
        public TimeSpan OffsetError { get; }

        /// <summary>One standard error of <see cref="Skew"/>; a third of the greatest credible skew while it cannot be told.</summary>
        public double SkewError { get; }

        /// <summary>Exchanges seen since the start or the last reset; 0 means that the line says nothing.</summary>
        public int Exchanges { get; }
    }
}
