using System;

namespace Nowpose.Sync
{
    /// <summary>What an estimator believes: Φ as a line over the headset clock, with its statistical uncertainty.</summary>
    public readonly struct ClockLine
    {
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

        /// <summary>One standard error of <see cref="Skew"/>; zero while it cannot be told.</summary>
        public double SkewError { get; }

        /// <summary>Exchanges seen since the start or the last reset; 0 means that the line says nothing.</summary>
        public int Exchanges { get; }
    }
}
