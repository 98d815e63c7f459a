using System;

namespace Nowpose.Latency
{
    /// <summary>Detects whether the median of the newest 15 lengths is above a limit, with hysteresis.</summary>
    /// <remarks>Allocates nothing; not thread-safe.</remarks>
    sealed class MedianLimit
    {
        const int Window = 15;
        const int MinCount = 8;

        /// <summary>
        /// Hysteresis. <see cref="IsBeyond"/> becomes false again when the median has stayed below ClearlyInside times the limit for
        /// <see cref="CountToReturn"/> lengths.
        /// </summary>
        internal const double ClearlyInside = 0.94;
        const int CountToReturn = 30;

        readonly RollingPercentiles _recent = new RollingPercentiles(Window);
        int _clear;

        /// <summary>Whether the median is above the limit; null without a limit, and with fewer than eight lengths.</summary>
        public bool? IsBeyond { get; private set; }

        /// <summary>Median of the newest 15 lengths; null without a length.</summary>
        public TimeSpan? Median => _recent.Count == 0 ? (TimeSpan?)null : _recent.At(0.5);

        /// <param name="limit">The limit, which may differ from that of the previous length; null if there is none.</param>
        public void Add(TimeSpan length, TimeSpan? limit)
        {
            _recent.Add(length);
            if (!limit.HasValue) Forget();
            else if (_recent.Count >= MinCount) Judge(_recent.At(0.5), limit.Value);
        }

        /// <summary>Removes all lengths.</summary>
        public void Reset()
        {
            _recent.Reset();
            Forget();
        }

        /// <summary>Forgets the result of the comparison, and keeps the lengths. Call it when the limit changes.</summary>
        public void Forget() => (IsBeyond, _clear) = (null, 0);

        void Judge(TimeSpan median, TimeSpan limit)
        {
            _clear = median.Ticks < ClearlyInside * limit.Ticks ? _clear + 1 : 0;
            if (median > limit) IsBeyond = true;
            else if (IsBeyond == null || _clear >= CountToReturn) IsBeyond = false;
        }
    }
}
