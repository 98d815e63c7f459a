using System;

namespace Nowpose.Sync
{
    /// <summary>When a clock counts as synchronised, and what its error bound is made of.</summary>
    public sealed class ClockSettings
    {
        public static readonly ClockSettings Default = new ClockSettings();

        /// <param name="exchangesToSynchronise">Exchanges before the state may be synchronised; 20 fill the paper's moving average.</param>
        /// <param name="errorToSynchroniseMs">Maximum estimated error (three standard errors) of a synchronised clock, ms.</param>
        /// <param name="holdoverAfterSeconds">Silence after which a coarse or synchronised clock is in holdover, s: ten missed exchanges.</param>
        /// <param name="stepMarginMs">How far an exchange must contradict the earlier ones to count as a step, ms.</param>
        /// <param name="startAnewAfterSeconds">Silence after which the old line is forgotten, s: the device slept, and quartzes drift.</param>
        /// <param name="greatestHoldoverErrorMs">Estimated error up to which a pose counts as current during a holdover, ms.</param>
        /// <param name="skewDoubtPpm">
        /// How much faster or slower a clock may run in a minute's time than its skew and the standard errors say, ppm; the
        /// bound grows by it while no exchange arrives. Quartzes that warm up change by a few.
        /// </param>
        /// <param name="coarseErrorMs">
        /// Maximum estimated error of a coarse clock, ms. A robot at 1 m/s is then shown within 10 mm of where it is, against some
        /// 100 mm without compensation.
        /// </param>
        public ClockSettings(
            int exchangesToSynchronise = 20, double errorToSynchroniseMs = 1, double holdoverAfterSeconds = 2,
            double stepMarginMs = 0.5, double startAnewAfterSeconds = 60, double greatestHoldoverErrorMs = 10,
            double skewDoubtPpm = 10, double coarseErrorMs = 10)
        {
            ExchangesToSynchronise = SettingRange.RequireCount(exchangesToSynchronise, 1, 10_000, "exchanges to synchronise");
            ErrorToSynchronise = SettingRange.RequireMs(errorToSynchroniseMs, 0.001, 1000, "error to synchronise");
            HoldoverAfter = SettingRange.RequireSeconds(holdoverAfterSeconds, 0.1, 3600, "holdover after");
            StepMargin = SettingRange.RequireMs(stepMarginMs, 0.01, 10_000, "step margin");
            StartAnewAfter = SettingRange.RequireSeconds(startAnewAfterSeconds, 1, 86_400, "start anew after");
            GreatestHoldoverError = SettingRange.RequireMs(greatestHoldoverErrorMs, 0, 1000, "greatest holdover error");
            CoarseError = SettingRange.RequireMs(coarseErrorMs, 0, 1000, "coarse error");
            SkewDoubt = SettingRange.Require(skewDoubtPpm, 0, 10_000, "skew doubt", "ppm") * 1e-6;
        }

        public int ExchangesToSynchronise { get; }
        public TimeSpan ErrorToSynchronise { get; }
        public TimeSpan CoarseError { get; }
        public TimeSpan HoldoverAfter { get; }
        public TimeSpan StepMargin { get; }
        public TimeSpan StartAnewAfter { get; }
        public TimeSpan GreatestHoldoverError { get; }

        /// <summary>Dimensionless, seconds of error a second.</summary>
        public double SkewDoubt { get; }

        /// <summary>Whether a pose may be called current by this clock: coarse, synchronised, or in a holdover that is still short.</summary>
        public bool Trusts(in ClockModel clock) => clock.State == ClockState.Synchronised || clock.State == ClockState.Coarse
            || (clock.State == ClockState.Holdover && clock.EstimatedError <= GreatestHoldoverError);

        /// <summary>
        /// Whether a display that uses this clock must show its ± too: the clock is coarse, or in a holdover with an estimated error
        /// above <see cref="ErrorToSynchronise"/>.
        /// </summary>
        public bool IsCoarse(in ClockModel clock) => clock.State == ClockState.Coarse
            || (clock.State == ClockState.Holdover && clock.EstimatedError > ErrorToSynchronise);
    }
}
