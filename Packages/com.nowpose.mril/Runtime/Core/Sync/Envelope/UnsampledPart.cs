using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Longest part of a coarse control clock's step that contains no recent exchange. Exchanges in the same part of the step agree to within
    /// microseconds, but have a common error of up to half of this part.
    /// </summary>
    sealed class UnsampledPart
    {
        /// <summary>
        /// Number of recent exchanges. Spread at random, they leave a gap of a twelfth of a step. They span a few seconds, in which the skew does
        /// not move them to another part of the step.
        /// </summary>
        const int Recent = 60;

        readonly long[] _parts = new long[Recent];

        /// <summary>Computes the part for a history of at least one exchange: zero without a resolution, the whole step for one exchange.</summary>
        public TimeSpan Of(BoundsHistory history, TimeSpan resolution)
        {
            var step = resolution.Ticks;
            if (step <= 0) return TimeSpan.Zero;
            var count = Math.Min(Recent, history.Count);
            // Uses headset time, because the start of a step is unknown and has no effect on the result.
            for (var i = 0; i < count; i++) _parts[i] = (history[i].Sent.SinceEpoch.Ticks % step + step) % step;
            Array.Sort(_parts, 0, count);
            var longest = _parts[0] + step - _parts[count - 1];
            for (var i = 1; i < count; i++) longest = Math.Max(longest, _parts[i] - _parts[i - 1]);
            return new TimeSpan(longest);
        }
    }
}
