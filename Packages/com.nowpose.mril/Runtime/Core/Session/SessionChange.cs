using System;

namespace Nowpose.Session
{
    /// <summary>What a user wants to be told when it happens, see <see cref="SessionWatch"/>. Several may happen at once.</summary>
    [Flags]
    public enum SessionChange
    {
        None = 0,

        /// <summary>
        /// The moment of light has been known well enough for half a second: for the first time, or again after
        /// <see cref="Lost"/>. Says nothing about samples.
        /// </summary>
        Synchronised = 1,

        /// <summary>It is no longer: a step of a clock is suspected, or no sync exchange has come for too long. Poses are not current.</summary>
        Lost = 2,

        /// <summary>
        /// The render time has been in the constant-latency range for half a second: for the first time, or again after
        /// <see cref="LeftRange"/>.
        /// </summary>
        EnteredRange = 4,

        /// <summary>The render time is beyond the constant-latency range: poses are drawn for a moment before their light appears.</summary>
        LeftRange = 8,

        /// <summary>
        /// The arm is held, for its samples are too old or too few, after half a second or more in which it was not. It is
        /// said once; the next time only after the arm was predicted for half a second again.
        /// </summary>
        Stale = 16,

        /// <summary>
        /// The display times that the headset's runtime predicts and the calibrated L_visu differ by more than 5 ms and do not
        /// cease to: one of them is wrong. The next time only after they agreed again.
        /// </summary>
        DisplayTimeDoubted = 32,

        /// <summary>
        /// The display times of the headset's runtime have been implausible for a second: in the past, or more than 500 ms ahead. L_visu is as
        /// calibrated wherever they are.
        /// </summary>
        DisplayTimeImplausible = 64,

        /// <summary>They have been plausible again for a second, after <see cref="DisplayTimeImplausible"/>.</summary>
        DisplayTimePlausible = 128,
    }
}
