using System;

namespace Nowpose.Sync
{
    /// <summary>Detects a slew of the control clock that is faster than the skew of any clock. It looks like a series of steps.</summary>
    /// <remarks>
    /// A line through a second of such a slew is wrong by more than its bound a second later. Steps to and fro, and steps that correct the skew of a
    /// clock, are not a slew: the line is right between them.
    /// </remarks>
    sealed class FastSlewDetector
    {
        /// <summary>
        /// Number of successive intervals between steps in which the offset changed in the same direction faster than the skew of any clock. A single
        /// interval may be between two real steps.
        /// </summary>
        const int MinIntervals = 2;

        /// <summary>Maximum time between two steps of a slew. The slew has ended when no step of it has occurred for this long.</summary>
        static readonly TimeSpan MaxInterval = TimeSpan.FromSeconds(10);

        ClockLine _previous;
        HeadsetTime? _until;
        int _rises;

        /// <summary>Adds a step.</summary>
        /// <param name="line">Clock line through the exchanges since the step.</param>
        public void Add(in ClockLine line)
        {
            var direction = Direction(line);
            // Falls count as negative rises.
            _rises = _rises * direction > 0 ? _rises + direction : direction;
            if (Math.Abs(_rises) >= MinIntervals) _until = line.Reference + MaxInterval;
            _previous = line;
        }

        public bool IsSlewedAt(HeadsetTime now) => now <= _until;

        // Returns 0 if the skew of a clock can cause the change of the offset since the previous step.
        int Direction(in ClockLine line)
        {
            var time = line.Reference - _previous.Reference;
            if (_previous.Exchanges == 0 || time > MaxInterval) return 0;
            var change = line.Offset - _previous.Offset;
            return ClockTicks.Seconds(change.Duration()) > ClockLine.MaxSkew * ClockTicks.Seconds(time) ? Math.Sign(change.Ticks) : 0;
        }
    }
}
