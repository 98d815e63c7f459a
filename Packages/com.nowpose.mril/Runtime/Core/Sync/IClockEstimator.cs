using System;

namespace Nowpose.Sync
{
    /// <summary>Estimates offset and skew from sync exchanges. Not thread-safe: <see cref="ClockSynchroniser"/> serialises the calls.</summary>
    interface IClockEstimator
    {
        /// <summary>The line after the newest exchange; <see cref="ClockLine.Exchanges"/> is 0 before the first exchange.</summary>
        ClockLine Line { get; }

        /// <summary>Possible error of the offset due to path changes that were not recognised, in addition to the standard error.</summary>
        TimeSpan PathChangeError { get; }

        /// <summary>
        /// Maximum distance of a correct line from the bounds of the recent exchanges. A line that stays farther outside them is wrong. Null if the
        /// line need not fit the bounds.
        /// </summary>
        TimeSpan? MaxOutsideBounds { get; }

        /// <param name="exchange">An exchange that has passed <see cref="SyncExchangeRules.Check"/> and is newer than all previous exchanges.</param>
        void Add(in SyncExchange exchange);

        /// <summary>Removes the estimate of the offset after a step or correction of a clock, or a long time without exchanges.</summary>
        /// <param name="skewUncertainty">
        /// Standard deviation of the change of the skew, dimensionless; small if the clocks still belong to the same machines. An estimator
        /// may ignore it.
        /// </param>
        void Restart(double skewUncertainty);
    }
}
