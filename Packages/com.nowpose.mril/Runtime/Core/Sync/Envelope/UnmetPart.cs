using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// The longest part of a coarse control clock's step that the recent exchanges all missed. Those that meet the same part
    /// agree to microseconds with one another, and are off by up to half of this together.
    /// </summary>
    sealed class UnmetPart
    {
        /// <summary>
        /// Exchanges looked at: spread at random they leave a twelfth of a step. In the seconds that they take, the clocks'
        /// rates do not spread them.
        /// </summary>
        const int Recent = 60;

        readonly long[] _parts = new long[Recent];

        /// <summary>Of a history of at least one exchange; zero when the resolution is, the whole step for one exchange.</summary>
        public TimeSpan Of(BoundsHistory history, TimeSpan resolution)
        {
            var step = resolution.Ticks;
            if (step <= 0) return TimeSpan.Zero;
            var count = Math.Min(Recent, history.Count);
            // By the headset's clock: where a step begins is not known, and does not matter.
            for (var i = 0; i < count; i++) _parts[i] = (history[i].Sent.SinceEpoch.Ticks % step + step) % step;
            Array.Sort(_parts, 0, count);
            var longest = _parts[0] + step - _parts[count - 1];
            for (var i = 1; i < count; i++) longest = Math.Max(longest, _parts[i] - _parts[i - 1]);
            return new TimeSpan(longest);
        }
    }
}
