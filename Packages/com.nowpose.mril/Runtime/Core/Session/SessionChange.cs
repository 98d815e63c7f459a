using System;

namespace Nowpose.Session
{
    /// <summary>Changes of a session that concern the user, see <see cref="SessionWatch"/>. Several may occur at once.</summary>
    [Flags]
    public enum SessionChange
    {
        None = 0,

        /// <summary>
        /// The display time has been accurate enough for half a second, for the first time or after <see cref="Lost"/>. Does not depend on
        /// samples.
        /// </summary>
        Synchronised = 1,

        /// <summary>The display time is no longer accurate enough: a clock step is suspected, or sync exchanges are missing.</summary>
        Lost = 2,

        /// <summary>
        /// The render time has been in the constant-latency range for half a second, for the first time or after
        /// <see cref="LeftRange"/>. Without a calibrated range: frames have not missed refreshes of the display for half a second, after
        /// <see cref="LeftRange"/>.
        /// </summary>
        EnteredRange = 4,

        /// <summary>
        /// The render time is beyond the constant-latency range, or frames miss refreshes of the display, so poses are displayed after the time for
        /// which they are computed.
        /// </summary>
        LeftRange = 8,

        /// <summary>
        /// The arm is held because its samples are too old or too few. Reported only if the arm was predicted for at least half a second
        /// before.
        /// </summary>
        Stale = 16,

        /// <summary>
        /// The display times that the headset's runtime predicts have differed from the calibrated L_visu by more than 5 ms for some time, so one
        /// of the two is wrong. Reported again only after the two have agreed.
        /// </summary>
        DisplayTimeInconsistent = 32,

        /// <summary>Former name of <see cref="DisplayTimeInconsistent"/>.</summary>
        [Obsolete("Use DisplayTimeInconsistent.")]
        DisplayTimeDoubted = DisplayTimeInconsistent,

        /// <summary>
        /// The display times of the headset's runtime have been implausible for a second: in the past, or more than 500 ms ahead. The
        /// calibrated L_visu replaces implausible display times.
        /// </summary>
        DisplayTimeImplausible = 64,

        /// <summary>The display times have been plausible for a second, after <see cref="DisplayTimeImplausible"/>.</summary>
        DisplayTimePlausible = 128,
    }
}
