using System;

namespace Nowpose.Latency
{
    /// <summary>Percentiles of the newest few lengths. Allocates nothing after construction; not thread-safe.</summary>
    sealed class RollingPercentiles
    {
        readonly long[] _byAge;
        readonly long[] _sorted;
        int _count;
        int _next;

        /// <param name="window">How many lengths are remembered, 1 or more.</param>
        public RollingPercentiles(int window)
        {
            if (window < 1) throw new ArgumentOutOfRangeException(nameof(window), window, "window must be 1 or more");
            _byAge = new long[window];
            _sorted = new long[window];
        }

        /// <summary>Lengths remembered.</summary>
        public int Count => _count;

        public void Add(TimeSpan length)
        {
            if (_count == _byAge.Length) Remove(_byAge[_next]);
            Insert(length.Ticks);
            _byAge[_next] = length.Ticks;
            _next = (_next + 1) % _byAge.Length;
        }

        /// <summary>The length below which a fraction of the remembered ones lie, interpolated between neighbours.</summary>
        /// <param name="fraction">0 (least) to 1 (greatest).</param>
        /// <exception cref="InvalidOperationException">Nothing is remembered yet.</exception>
        public TimeSpan At(double fraction)
        {
            if (_count == 0) throw new InvalidOperationException("no length was added yet; check Count first");
            if (!(fraction >= 0 && fraction <= 1)) throw new ArgumentOutOfRangeException(nameof(fraction), fraction, "fraction must be 0 to 1");
            var position = fraction * (_count - 1);
            var below = (int)position;
            var above = Math.Min(below + 1, _count - 1);
            return new TimeSpan((long)Math.Round(_sorted[below] + (position - below) * (_sorted[above] - _sorted[below])));
        }

        public void Reset() => _count = _next = 0;

        void Remove(long ticks)
        {
            var at = Array.BinarySearch(_sorted, 0, _count, ticks);
            _count--;
            Array.Copy(_sorted, at + 1, _sorted, at, _count - at);
        }

        void Insert(long ticks)
        {
            var at = Array.BinarySearch(_sorted, 0, _count, ticks);
            if (at < 0) at = ~at;
            Array.Copy(_sorted, at, _sorted, at + 1, _count - at);
            _sorted[at] = ticks;
            _count++;
        }
    }
}
