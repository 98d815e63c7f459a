namespace Nowpose
{
    /// <summary>Accuracy with which the offset between headset clock and control clock is known.</summary>
    /// <remarks>The numbers must not change, because projects may have stored them.</remarks>
    public enum ClockState
    {
        /// <summary>No exchange has been used yet.</summary>
        Unsynchronised = 0,

        /// <summary>
        /// An offset is known, but not accurately enough: there are too few exchanges, the estimated error is above
        /// <see cref="Sync.ClockSettings.CoarseError"/>, the server itself is not synchronised, or a step is suspected.
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

        /// <summary>The clock was coarse or synchronised, but no exchange has arrived recently, so the last estimate is extrapolated.</summary>
        Holdover = 3,
    }

    static class ClockStateWord
    {
        static readonly EnumNames<ClockState> Names = new EnumNames<ClockState>(state => (int)state);

        /// <summary>Returns the name of a state in the protocol, in files, on pages, in logs and on command lines.</summary>
        public static string Word(this ClockState state) => Names.NameOf(state);
    }
}
