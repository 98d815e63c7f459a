namespace Nowpose.Session.Hindcast
{
    /// <summary>Squared errors of one quantity in one frame, in the quantity's unit squared.</summary>
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

        /// <summary>Square of the error that the uncompensated hold would have had.</summary>
        public double HeldSquared { get; }

        /// <summary>Square of the uncertainty of the true value.</summary>
        public double TruthSquared { get; }

        /// <summary>Square of the error that the clock's error bound allows.</summary>
        public double ClockSquared { get; }
    }
}
