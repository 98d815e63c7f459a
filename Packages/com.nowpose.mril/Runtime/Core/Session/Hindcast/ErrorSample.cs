namespace Nowpose.Session.Hindcast
{
    /// <summary>What one frame tells of one quantity: squares of its errors, in the quantity's unit squared.</summary>
    readonly struct ErrorSample
    {
        public ErrorSample(double displayedSquared, double heldSquared, double truthSquared, double clockSquared)
        {
            DisplayedSquared = displayedSquared;
            HeldSquared = heldSquared;
            TruthSquared = truthSquared;
            ClockSquared = clockSquared;
        }

        public double DisplayedSquared { get; }

        /// <summary>Of the error that the hold would have had.</summary>
        public double HeldSquared { get; }

        /// <summary>Of what the truth may be off.</summary>
        public double TruthSquared { get; }

        /// <summary>Of what the clock's bound can hide.</summary>
        public double ClockSquared { get; }
    }
}
