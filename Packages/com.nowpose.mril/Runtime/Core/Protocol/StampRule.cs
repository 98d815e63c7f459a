using System;

namespace Nowpose.Protocol
{
    /// <summary>Which stamps are believed.</summary>
    static class StampRule
    {
        /// <summary>Whether a stamp lies further ahead than the clock's own uncertainty and the protocol's allowance explain.</summary>
        /// <param name="now">The control time at which the message arrived, as the receiver believes it.</param>
        /// <param name="clockErrorBound">How wrong <paramref name="now"/> may be.</param>
        public static bool IsInFuture(ControlTime stamp, ControlTime now, TimeSpan clockErrorBound) =>
            // In ticks: a stamp from the wire minus a clock of another epoch may exceed what TimeSpan arithmetic bears.
            (decimal)stamp.SinceEpoch.Ticks - now.SinceEpoch.Ticks > (decimal)clockErrorBound.Ticks + ProtocolLimits.FutureAllowance.Ticks;
    }
}
