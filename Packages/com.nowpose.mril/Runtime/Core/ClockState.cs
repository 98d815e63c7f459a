namespace Nowpose
{
    /// <summary>How well the headset clock is tied to the control clock.</summary>
    /// <remarks>The numbers stay as they are: projects may have stored them.</remarks>
    public enum ClockState
    {
        /// <summary>No exchange yet.</summary>
        Unsynchronised = 0,

        /// <summary>
        /// An offset is known, but its error is not limited yet: at the start, after a step or a long silence, and while a step
        /// is suspected.
        /// </summary>
        Converging = 1,

        /// <summary>
        /// The offset is known to within <see cref="ClockModel.EstimatedError"/>, which is at most
        /// <see cref="Sync.ClockSettings.CoarseError"/>. A pose is current, and what shows it also shows that error.
        /// </summary>
        Coarse = 4,

        /// <summary>
        /// The offset is known to within <see cref="ClockModel.EstimatedError"/>, which is at most
        /// <see cref="Sync.ClockSettings.ErrorToSynchronise"/>.
        /// </summary>
        Synchronised = 2,

        /// <summary>Was coarse or synchronised. No exchange has arrived for a while, so the last line is continued.</summary>
        Holdover = 3,
    }
}
