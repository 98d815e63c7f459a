namespace Nowpose.Sync
{
    /// <summary>Change of a clock, of its resolution or of the server's estimate, as indicated by an exchange.</summary>
    enum ClockChange
    {
        None,

        /// <summary>The exchange is inconsistent with earlier exchanges. More exchanges are needed to determine the cause.</summary>
        Suspected,

        /// <summary>
        /// The resolution of the control clock has changed. Its time stamps are early by half the resolution on average, so no line fits both the
        /// earlier and the new exchanges.
        /// </summary>
        Resolution,

        /// <summary>
        /// The server corrected its estimate of the control clock, by no more than the error bounds that it stated. The control clock, and with it
        /// the stamps of the samples, did not change.
        /// </summary>
        ServerCorrection,

        /// <summary>A clock stepped, perhaps because another machine now provides the control clock.</summary>
        Step,
    }
}
