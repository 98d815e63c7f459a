namespace Nowpose
{
    /// <summary>How accurately the offset between headset clock and control clock is known.</summary>
    /// <remarks>The numbers must not change, because projects may have stored them.</remarks>
    public enum ClockState
    {
        /// <summary>No exchange yet.</summary>
        Unsynchronised = 0,

        /// <summary>
        /// An offset is known, but its error is not bounded yet: at the start, after a step or a long silence, and while a step
        /// is suspected.
        /// </summary>
        Converging = 1,

        /// <summary>
        /// The offset is known to within <see cref="ClockModel.EstimatedError"/>, which is at most
        /// <see cref="Sync.ClockSettings.CoarseError"/>. A pose is current, and its display also shows that error.
        /// </summary>
        Coarse = 4,

        /// <summary>
        /// The offset is known to within <see cref="ClockModel.EstimatedError"/>, which is at most
        /// <see cref="Sync.ClockSettings.ErrorToSynchronise"/>.
        /// </summary>
        Synchronised = 2,

        /// <summary>Was coarse or synchronised. No exchange has arrived recently, so the last line is extrapolated.</summary>
        Holdover = 3,
    }

    static class ClockStateWord
    {
        /// <summary>Returns the spelling in the protocol, pages, logs and command lines.</summary>
        public static string Word(this ClockState state) => state.ToString().ToLowerInvariant();
    }
}
