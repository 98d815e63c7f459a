using System;

namespace Nowpose.Sync
{
    /// <summary>
    /// The clock that the wearer sees by: follows what the synchroniser believes without ever going back. A correction is
    /// spread over the next frames; only a step of a clock is taken over at once. One thread, the frame's; allocates nothing.
    /// </summary>
    /// <remarks>
    /// Control time advances by between 0.994 and 1.006 of the headset's while the clock is synchronised, by between 0.949
    /// and 1.051 while it is coarse, and by between one half and one and a half before. It never stops or goes back. It is shown
    /// as converging until it has caught up with the first estimate that is usable: no pose is current by a clock that is still
    /// tens of milliseconds away from it.
    /// </remarks>
    public sealed class DisplayClock
    {
        /// <summary>
        /// Seconds of correction a second, synchronised: a usual correction of 20 µs is done within a frame, one of 1 ms
        /// after a silence in a fifth of a second; and a robot at 1 m/s seems to move by 5 mm/s too fast or slow meanwhile.
        /// </summary>
        public const double SlewRate = 5e-3;

        /// <summary>The same while coarse: the first estimates are off by a few milliseconds, which are gone in a tenth of a second.</summary>
        public const double CoarseSlewRate = 0.05;

        /// <summary>The same before: the first offsets may be wrong by tens of milliseconds, and poses are not shown as current yet.</summary>
        public const double ConvergingSlewRate = 0.5;

        ClockModel _shown;
        HeadsetTime _at;
        bool _isCatchingUp;

        /// <summary>The model to show a frame by.</summary>
        /// <param name="believed">What the synchroniser says at that time.</param>
        /// <param name="now">When the frame begins. A time before the last call's is answered, but not followed.</param>
        public ClockModel Follow(in ClockModel believed, HeadsetTime now)
        {
            // A young line through two late replies can be so steep that following it would go back.
            var skew = Math.Max(-ClockLine.GreatestSkew, Math.Min(ClockLine.GreatestSkew, believed.Skew));
            if (!believed.IsKnown || !_shown.IsKnown || believed.Steps != _shown.Steps)
            {
                _isCatchingUp = false;
                return Show(new ClockModel(
                    now, believed.OffsetAt(now), skew, believed.ErrorBound, believed.State, believed.Steps, believed.EstimatedError), now);
            }
            if (now < _at) return _shown;

            var passed = now - _at;
            _isCatchingUp |= believed.State == ClockState.Converging;
            var allowed = (long)(passed.Ticks * RateOf(_isCatchingUp ? ClockState.Converging : believed.State));
            // What the clocks do by themselves is no correction.
            var carried = _shown.OffsetAt(_at) + new TimeSpan((long)Math.Round(passed.Ticks * skew));
            var correction = (believed.OffsetAt(now) - carried).Ticks;
            var taken = Math.Max(-allowed, Math.Min(allowed, correction));
            var left = new TimeSpan(Math.Abs(correction - taken));
            _isCatchingUp &= believed.State == ClockState.Converging || left > TimeSpan.Zero;
            var state = _isCatchingUp ? ClockState.Converging : believed.State;
            return Show(
                new ClockModel(
                    now, carried + new TimeSpan(taken), skew, believed.ErrorBound + left, state, believed.Steps,
                    believed.EstimatedError + left), now);
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
