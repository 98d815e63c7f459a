namespace Nowpose.Sync.Envelope
{
    /// <summary>How the offset runs towards the present, without its height: slope·x + bend·x².</summary>
    readonly struct OffsetCurve
    {
        public OffsetCurve(double slope, double bend)
        {
            Slope = slope;
            Bend = bend;
        }

        /// <summary>γ₂−1 at the reference, dimensionless.</summary>
        public double Slope { get; }

        /// <summary>Half the rate at which the skew changes, 1/s.</summary>
        public double Bend { get; }

        /// <param name="x">Seconds since the reference, zero or negative.</param>
        /// <returns>Seconds above the height at the reference.</returns>
        public double At(double x) => (Slope + Bend * x) * x;
    }
}
