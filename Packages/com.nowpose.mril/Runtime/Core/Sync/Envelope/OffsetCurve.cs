namespace Nowpose.Sync.Envelope
{
    /// <summary>Shape of the offset over time, without its height: slope·x + bend·x².</summary>
    readonly struct OffsetCurve
    {
        public OffsetCurve(double slope, double bend) => (Slope, Bend) = (slope, bend);

        /// <summary>Skew γ₂−1 at the reference time, dimensionless.</summary>
        public double Slope { get; }

        /// <summary>Half the rate of change of the skew, 1/s.</summary>
        public double Bend { get; }

        /// <param name="x">Seconds since the reference time, zero or negative.</param>
        /// <returns>Offset minus its value at the reference time, s.</returns>
        public double At(double x) => (Slope + Bend * x) * x;
    }
}
