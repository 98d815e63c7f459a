using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Bounds of the newest exchanges, newest first, limited by count, age, and the server's error bound. Allocates nothing after construction.
    /// </summary>
    /// <remarks>
    /// A server that follows another clock corrects its clock with each better estimate, and states a smaller error bound from then on. The
    /// exchanges before the corrections would tilt a line, so the oldest exchanges expire if their error bounds are much larger than the newest one.
    /// </remarks>
    sealed class BoundsHistory
    {
        /// <summary>Minimum number of exchanges that remain when the server's error bound decreases, so that the clock remains coarse.</summary>
        const int MinCount = ClockSynchroniser.ExchangesToBeCoarse;

        /// <summary>
        /// An old exchange expires if its server error bound exceeds ServerErrorRatio times the newest one plus ServerErrorMargin, in ticks. Smaller
        /// corrections move a line by less than the typical error of a network.
        /// </summary>
        const long ServerErrorRatio = 2, ServerErrorMargin = TimeSpan.TicksPerMillisecond;

        // Contains the history in a contiguous part, which moves towards the start with each exchange. Indices that wrap around would make the many
        // loops over the history slower.
        readonly OffsetBounds[] _all;
        readonly int _most;
        readonly TimeSpan _oldest;
        readonly bool _expiresByServerError;
        int _newest;

        /// <param name="most">Maximum number of exchanges.</param>
        /// <param name="oldest">Maximum age of an exchange relative to the newest exchange.</param>
        /// <param name="expiresByServerError">Whether exchanges expire when the server's error bound has decreased.</param>
        public BoundsHistory(int most, TimeSpan oldest, bool expiresByServerError = false)
        {
            _expiresByServerError = expiresByServerError;
            _all = new OffsetBounds[most + most / 2];
            (_most, _newest) = (most, _all.Length);
            _oldest = oldest;
        }

        public int Count { get; private set; }

        /// <param name="age">Index from 0, the newest, to <see cref="Count"/> − 1, the oldest.</param>
        public ref readonly OffsetBounds this[int age] => ref _all[_newest + age];

        public void Add(in OffsetBounds bounds)
        {
            if (Count == _most) Count--;
            if (_newest == 0)
            {
                _newest = _all.Length - Count;
                Array.Copy(_all, 0, _all, _newest, Count);
            }
            _all[--_newest] = bounds;
            Count++;
            while (bounds.Received - this[Count - 1].Received > _oldest) Count--;
            if (!_expiresByServerError) return;
            var maxServerError = ServerErrorRatio * bounds.ServerErrorBound + ServerErrorMargin;
            while (Count > MinCount && this[Count - 1].ServerErrorBound > maxServerError) Count--;
        }

        /// <summary>Moves the bounds of one exchange; the amounts are in ticks.</summary>
        public void Shift(int age, long lower, long upper)
        {
            ref var bounds = ref _all[_newest + age];
            bounds = bounds.Shifted(lower, upper);
        }

        public void Clear() => Count = 0;
    }
}
