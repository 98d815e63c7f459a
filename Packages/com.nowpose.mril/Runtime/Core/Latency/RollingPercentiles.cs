using System;

namespace Nowpose.Latency
{
    /// <summary>Percentiles of the newest time spans. Allocates nothing after construction; not thread-safe.</summary>
    sealed class RollingPercentiles
    {
        readonly long[] _byAge;
        readonly long[] _sorted;
        int _count;
        int _next;

        /// <param name="window">Maximum number of stored values, 1 or more.</param>
        public RollingPercentiles(int window)
        {
            _byAge = new long[window];
            _sorted = new long[window];
        }

        /// <summary>Number of stored values.</summary>
        public int Count => _count;

        public void Add(TimeSpan length)
        {
            if (_count == _byAge.Length) Remove(_byAge[_next]);
            Insert(length.Ticks);
            _byAge[_next] = length.Ticks;
            _next = (_next + 1) % _byAge.Length;
        }

        /// <summary>Returns the quantile of the stored values, interpolated linearly between adjacent values. Requires at least one value.</summary>
        /// <param name="fraction">0 (minimum) to 1 (maximum).</param>
        public TimeSpan At(double fraction)
        {
            var position = fraction * (_count - 1);
            var below = (int)position;
            var above = Math.Min(below + 1, _count - 1);
            return new TimeSpan((long)Math.Round(_sorted[below] + (position - below) * (_sorted[above] - _sorted[below])));
        }

        public void Reset() => _count = 0;

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
