using System;

namespace Nowpose.Sync
{
    /// <summary>Conditions for a synchronised clock, and parameters of its error bound.</summary>
    public sealed class ClockSettings
    {
        public static readonly ClockSettings Default = new ClockSettings();

        /// <param name="exchangesToSynchronise">
        /// Minimum number of exchanges before the clock counts as synchronised. The default, 20, is the length of the paper's moving average.
        /// </param>
        /// <param name="errorToSynchroniseMs">Maximum estimated error (three standard errors) at which the clock counts as synchronised, ms.</param>
        /// <param name="holdoverAfterSeconds">
        /// Time without exchanges after which a coarse or synchronised clock goes into holdover, s. The default corresponds to ten missed exchanges.
        /// </param>
        /// <param name="stepMarginMs">Minimum amount by which an exchange must contradict earlier exchanges to indicate a step, ms.</param>
        /// <param name="restartAfterSeconds">
        /// Time without exchanges after which the estimate restarts, s, because the headset may have slept and the skew may have changed.
        /// </param>
        /// <param name="maxHoldoverErrorMs">Maximum estimated error at which a pose still counts as current in holdover, ms.</param>
        /// <param name="skewVariationPpm">
        /// Possible change of the skew within a minute, in addition to its standard errors, ppm. The error bound grows at this rate while no exchange
        /// arrives. While a quartz clock warms up, its rate changes by a few ppm.
        /// </param>
        /// <param name="coarseErrorMs">
        /// Maximum estimated error at which the clock counts as coarse, ms. With the default, a robot that moves at 1 m/s is shown at most 10 mm from
        /// its position; without compensation, the distance is about 100 mm.
        /// </param>
        public ClockSettings(
            int exchangesToSynchronise = 20, double errorToSynchroniseMs = 1, double holdoverAfterSeconds = 2,
            double stepMarginMs = 0.5, double restartAfterSeconds = 60, double maxHoldoverErrorMs = 10,
            double skewVariationPpm = 10, double coarseErrorMs = 10)
        {
            ExchangesToSynchronise = SettingRange.RequireCount(exchangesToSynchronise, 1, 10_000, "exchanges to synchronise");
            ErrorToSynchronise = SettingRange.RequireMs(errorToSynchroniseMs, 0.001, 1000, "error to synchronise");
            HoldoverAfter = SettingRange.RequireSeconds(holdoverAfterSeconds, 0.1, 3600, "holdover after");
            StepMargin = SettingRange.RequireMs(stepMarginMs, 0.01, 10_000, "step margin");
            RestartAfter = SettingRange.RequireSeconds(restartAfterSeconds, 1, 86_400, "restart after");
            MaxHoldoverError = SettingRange.RequireMs(maxHoldoverErrorMs, 0, 1000, "maximum holdover error");
            CoarseError = SettingRange.RequireMs(coarseErrorMs, 0, 1000, "coarse error");
            SkewVariation = SettingRange.Require(skewVariationPpm, 0, 10_000, "skew variation", "ppm") * 1e-6;
        }

        public int ExchangesToSynchronise { get; }
        public TimeSpan ErrorToSynchronise { get; }
        public TimeSpan CoarseError { get; }
        public TimeSpan HoldoverAfter { get; }
        public TimeSpan StepMargin { get; }
        public TimeSpan RestartAfter { get; }
        public TimeSpan MaxHoldoverError { get; }

        /// <summary>
        /// Growth rate of the error bound in addition to the standard errors of the skew; dimensionless (seconds of error per second).
        /// </summary>
        public double SkewVariation { get; }

        /// <summary>
        /// Returns whether a pose based on this clock counts as current: the clock is coarse, synchronised, or in a short holdover.
        /// </summary>
        public bool Trusts(in ClockModel clock) => clock.State == ClockState.Synchronised || clock.State == ClockState.Coarse
            || (clock.State == ClockState.Holdover && clock.EstimatedError <= MaxHoldoverError);

        /// <summary>
        /// Returns whether a display that uses this clock must also show its estimated error (±): the clock is coarse, or in a holdover with an
        /// estimated error above <see cref="ErrorToSynchronise"/>.
        /// </summary>
        public bool IsCoarse(in ClockModel clock) => clock.State == ClockState.Coarse
            || (clock.State == ClockState.Holdover && clock.EstimatedError > ErrorToSynchronise);
    }
}
