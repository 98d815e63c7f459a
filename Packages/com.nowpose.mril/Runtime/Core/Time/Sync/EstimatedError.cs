using System;

namespace Nowpose.Sync
{
    /// <summary>The error of the clock offset that the estimator expects, as shown to users: three standard errors.</summary>
    static class EstimatedError
    {
        /// <returns>Null while the offset or its error is not known.</returns>
        public static TimeSpan? Of(ClockSynchroniser clock) =>
            clock.OffsetError > TimeSpan.Zero ? new TimeSpan(3 * clock.OffsetError.Ticks) : (TimeSpan?)null;
    }
}
