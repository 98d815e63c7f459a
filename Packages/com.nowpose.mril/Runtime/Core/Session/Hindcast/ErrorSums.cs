using Nowpose.Prediction;

namespace Nowpose.Session.Hindcast
{
    /// <summary>
    /// Squared errors of one quantity, in the quantity's unit squared: those of one frame, or their sums over frames, from which root mean
    /// squares are computed.
    /// </summary>
    struct ErrorSums
    {
        /// <summary>Number of frames.</summary>
        public int Count;

        public double Displayed;

        /// <summary>Square of the error that the uncompensated hold would have had.</summary>
        public double Held;

        /// <summary>Square of the uncertainty of the true value.</summary>
        public double Truth;

        /// <summary>Square of the error that the clock's error bound allows.</summary>
        public double Clock;

        /// <summary>Creates the errors of one frame.</summary>
        public ErrorSums(double displayed, double held, double truth, double clock) =>
            (Count, Displayed, Held, Truth, Clock) = (1, displayed, held, truth, clock);

        /// <summary>Whether the errors of one frame are those of a motion. The square of a corrupt position is infinite, and a sum would remain so.</summary>
        public bool IsPlausible => Displayed + Held + Truth + Clock < JointSample.MaxMagnitude * JointSample.MaxMagnitude;

        public void Add(in ErrorSums sums)
        {
            Count += sums.Count;
            Displayed += sums.Displayed;
            Held += sums.Held;
            Truth += sums.Truth;
            Clock += sums.Clock;
        }
    }
}
