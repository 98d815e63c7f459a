namespace Nowpose.Sync
{
    /// <summary>Change of the clocks that an exchange indicates, other than the offset estimate.</summary>
    enum ClockChange
    {
        None,

        /// <summary>The exchange is inconsistent with the earlier ones. One or two more are needed to determine the cause.</summary>
        Suspected,

        /// <summary>
        /// The resolution of the control clock has changed. Its time stamps are earlier than their events by half the resolution on
        /// average, so that no line fits both these exchanges and the earlier ones.
        /// </summary>
        Resolution,

        /// <summary>A clock stepped by less than a round-trip time. Both clocks are still the same ones.</summary>
        ShortStep,

        /// <summary>A clock stepped, perhaps because the control clock is that of another machine now.</summary>
        LongStep,
    }
}
