using System;

namespace Nowpose.Protocol
{
    /// <summary>The rule for stamps in the future.</summary>
    static class StampRule
    {
        /// <summary>
        /// Maximum time by which a plausible stamp is ahead of the control clock, in addition to its error bound. Two clocks synchronised by NTP differ
        /// by less.
        /// </summary>
        public static readonly TimeSpan PlausibleAhead = TimeSpan.FromMilliseconds(50);

        /// <summary>Returns whether a stamp is in the future by more than the clock's error bound plus the protocol's allowance.</summary>
        /// <param name="now">The receiver's estimate of the control time at which the message arrived.</param>
        /// <param name="clockErrorBound">Error bound of <paramref name="now"/>.</param>
        public static bool IsInFuture(ControlTime stamp, ControlTime now, TimeSpan clockErrorBound) =>
            stamp - now > clockErrorBound + ProtocolLimits.FutureAllowance;
    }
}
