using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Computes the longest part of a coarse control clock's step into which no recent exchange falls. If all exchanges fall into the same part of
    /// the step, they agree to within microseconds but have a common error, which is up to half of the part without exchanges.
    /// </summary>
    sealed class UnsampledPart
    {
        /// <summary>
        /// Number of recent exchanges that are used. If they are spread at random over the step, the longest gap is about a twelfth of the step.
        /// They span a few seconds. In this time, the skew does not move them to another part of the step.
        /// </summary>
        const int Recent = 60;

        /// <summary>
        /// The longest gap of exchanges at random times exceeds the step divided by this number with a probability of 0.1 %.
        /// </summary>
        const int RandomDivisor = 6;

        readonly long[] _parts = new long[Recent];

        /// <summary>Computes the part for a history of at least one exchange: zero without a resolution, the whole step for one exchange.</summary>
        public TimeSpan Of(BoundsHistory history, TimeSpan resolution)
        {
            var step = resolution.Ticks;
            if (step <= 0) return TimeSpan.Zero;
            var count = Math.Min(Recent, history.Count);
            // Uses headset times, because the result does not depend on the start of a step, which is unknown.
            for (var i = 0; i < count; i++) _parts[i] = (history[i].Sent.SinceEpoch.Ticks % step + step) % step;
            Array.Sort(_parts, 0, count);
            var longest = _parts[0] + step - _parts[count - 1];
            for (var i = 1; i < count; i++) longest = Math.Max(longest, _parts[i] - _parts[i - 1]);
            return new TimeSpan(longest);
        }

        /// <summary>
        /// Returns the maximum error that all exchanges have in common beyond that of random times, which the error of the fit includes: half of the part,
        /// without the length that random times leave.
        /// </summary>
        public static TimeSpan CommonError(TimeSpan part, TimeSpan resolution) =>
            new TimeSpan(Math.Max(0, part.Ticks - resolution.Ticks / RandomDivisor) / 2);
    }
}
