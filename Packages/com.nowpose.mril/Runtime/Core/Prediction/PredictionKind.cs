namespace Nowpose.Prediction
{
    /// <summary>How a displayed position was made.</summary>
    public enum PredictionKind
    {
        /// <summary>No sample yet: the position is a placeholder (0) and must not be shown as a pose.</summary>
        None,

        /// <summary>A value that stands still: the newest sample's, or the section's at the horizon cap or at its oldest sample.</summary>
        Held,

        /// <summary>From the section's polynomial, at or before the newest sample.</summary>
        Interpolated,

        /// <summary>From the section's polynomial, ahead of the newest sample.</summary>
        Predicted,

        /// <summary>Where the control system means the joint to be, as late as it follows: nothing is predicted.</summary>
        Planned
    }
}
