using System;

namespace Nowpose.Sync
{
    /// <summary>
    /// Clock for the display. Follows the synchroniser's model, and spreads a correction over the next frames, so that time does not go back. A step
    /// of a clock, and a correction of more than a second, take effect at once. Use it only on the thread that computes the frames; allocates nothing.
    /// </summary>
    /// <remarks>
    /// Control time advances at 0.994 to 1.006 times the rate of headset time while the clock is synchronised, at 0.949 to 1.051 times while
    /// it is coarse, and at 0.5 to 1.5 times before that. Apart from these jumps, it never stops or goes back. The state is converging
    /// until this clock has caught up with the first usable estimate, and while it catches up with an estimate that is more than 10 ms away, for
    /// example after a time without exchanges, because a pose is not current while the clock is tens of milliseconds away from the estimate.
    /// </remarks>
    public sealed class DisplayClock
    {
        /// <summary>
        /// Maximum rate of correction while the clock is synchronised, in s/s. A typical correction of 20 µs takes less than a frame. A correction of
        /// 1 ms, after a time without exchanges, takes a fifth of a second, during which a robot at 1 m/s appears 5 mm/s too fast or too slow.
        /// </summary>
        public const double SlewRate = 5e-3;

        /// <summary>
        /// Maximum rate of correction while the clock is coarse, in s/s. It removes an initial error of a few milliseconds in a tenth of a second.
        /// </summary>
        public const double CoarseSlewRate = 0.05;

        /// <summary>
        /// Maximum rate of correction while the clock is converging, in s/s, because the first offsets may be wrong by tens of milliseconds.
        /// </summary>
        public const double ConvergingSlewRate = 0.5;

        /// <summary>Maximum correction during which a pose counts as current.</summary>
        static readonly TimeSpan MaxUsableCorrection = ClockSettings.Default.CoarseError;

        /// <summary>
        /// Minimum correction that takes effect at once. The first offset after a sleep is wrong by half of the sleep if the reply to its exchange was
        /// read only then: spreading its correction over the frames would take as long as the sleep.
        /// </summary>
        static readonly TimeSpan MinJump = TimeSpan.FromSeconds(1);

        ClockModel _shown;
        HeadsetTime _at;
        bool _isCatchingUp;

        /// <summary>
        /// Whether the times of the newest and the previous frame cannot be compared: the clock stepped, was corrected by more than a second, or became
        /// known or unknown.
        /// </summary>
        internal bool IsRestarted { get; private set; }

        /// <summary>Returns the clock model for a frame.</summary>
        /// <param name="estimate">The synchroniser's model at <paramref name="now"/>.</param>
        /// <param name="now">Start of the frame. If it is before the start in the last call, the last model is returned and nothing changes.</param>
        public ClockModel Follow(in ClockModel estimate, HeadsetTime now)
        {
            IsRestarted = estimate.Steps != _shown.Steps || estimate.IsKnown != _shown.IsKnown;
            // An early line through two late replies can be so steep that time would go back.
            var skew = ClockLine.LimitSkew(estimate.Skew);
            if (IsRestarted || !estimate.IsKnown) return Restart(estimate, skew, now);
            if (now < _at) return _shown;

            var passed = now - _at;
            // The change of the offset due to the skew does not count as a correction.
            var carried = _shown.OffsetAt(_at) + new TimeSpan((long)Math.Round(passed.Ticks * skew));
            var correction = (estimate.OffsetAt(now) - carried).Ticks;
            IsRestarted = Math.Abs(correction) > MinJump.Ticks;
            if (IsRestarted) return Restart(estimate, skew, now);
            _isCatchingUp |= estimate.State == ClockState.Converging || Math.Abs(correction) > MaxUsableCorrection.Ticks;
            var allowed = (long)(passed.Ticks * RateOf(_isCatchingUp ? ClockState.Converging : estimate.State));
            var taken = Math.Max(-allowed, Math.Min(allowed, correction));
            var left = new TimeSpan(Math.Abs(correction - taken));
            _isCatchingUp &= estimate.State == ClockState.Converging || left > TimeSpan.Zero;
            var state = _isCatchingUp ? ClockState.Converging : estimate.State;
            return Show(
                new ClockModel(
                    now, carried + new TimeSpan(taken), skew, estimate.ErrorBound + left, state, estimate.Steps,
                    estimate.EstimatedError + left), now);
        }

        ClockModel Restart(in ClockModel estimate, double skew, HeadsetTime now)
        {
            _isCatchingUp = false;
            return Show(
                new ClockModel(now, estimate.OffsetAt(now), skew, estimate.ErrorBound, estimate.State, estimate.Steps, estimate.EstimatedError), now);
        }

        static double RateOf(ClockState state) =>
            state == ClockState.Converging ? ConvergingSlewRate : state == ClockState.Coarse ? CoarseSlewRate : SlewRate;

        ClockModel Show(in ClockModel model, HeadsetTime now)
        {
            _at = now;
            return _shown = model;
        }
    }
}
