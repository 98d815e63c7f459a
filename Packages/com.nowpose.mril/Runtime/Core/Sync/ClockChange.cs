namespace Nowpose.Sync
{
    /// <summary>What an exchange tells of the clocks beside their offset.</summary>
    enum ClockChange
    {
        None,

        /// <summary>It does not go with the earlier ones; one or two more will tell why.</summary>
        Suspected,

        /// <summary>
        /// The control clock has another resolution now: its stamps lie by half of that before the moments that they are of, so that
        /// no line goes through them and the earlier ones.
        /// </summary>
        Resolution,

        /// <summary>A clock stepped by less than a round trip: the same two clocks, which have not changed otherwise.</summary>
        ShortStep,

        /// <summary>A clock stepped, perhaps because it is another machine's now.</summary>
        LongStep,
    }
}
