using System;

namespace Nowpose.Signals
{
    /// <summary>
    /// Keeps the values of more than a second with a resolution of 20 ms, because a signal's message can arrive later than the samples that
    /// predictors keep.
    /// </summary>
    /// <remarks>Allocates nothing after construction.</remarks>
    sealed class PastValues<T>
    {
        /// <summary>Capacity in values: 1.24 s at any sampling interval.</summary>
        const int Capacity = 64;

        /// <summary>Number of values kept per second of a fast source. Of the samples in an interval of 20 ms, the last one is kept.</summary>
        const int Rate = 50;

        readonly (double Time, T Value)[] _values = new (double, T)[Capacity];
        readonly Func<T, T, double, T> _interpolate;
        readonly double _maximumGap;
        int _newest, _count;

        /// <param name="maximumGap">Maximum time between two values of the same motion, s.</param>
        /// <param name="interpolate">Interpolates between two values: 0 for the first, 1 for the second.</param>
        public PastValues(double maximumGap, Func<T, T, double, T> interpolate) => (_maximumGap, _interpolate) = (maximumGap, interpolate);

        /// <summary>Adds a value. A value that is not newer than the newest one has no effect.</summary>
        /// <param name="time">Time since the epoch of the samples, s.</param>
        public void Add(double time, in T value)
        {
            if (_count > 0 && time <= _values[_newest].Time) return;
            if (_count == 0 || Math.Floor(time * Rate) > Math.Floor(_values[_newest].Time * Rate))
            {
                _newest = (_newest + 1) % Capacity;
                _count = Math.Min(_count + 1, Capacity);
            }
            _values[_newest] = (time, value);
        }

        /// <summary>Gets the value at a given time.</summary>
        /// <returns>False if the time is not between two values, or if the time between these values exceeds the maximum.</returns>
        public bool TryGet(double time, out T value)
        {
            var isNewest = _count > 0 && time == _values[_newest].Time;
            value = isNewest ? _values[_newest].Value : default;
            if (isNewest) return true;
            for (var age = 1; age < _count; age++)
            {
                ref readonly var before = ref _values[(_newest - age + Capacity) % Capacity];
                if (before.Time > time) continue;
                ref readonly var after = ref _values[(_newest - age + 1 + Capacity) % Capacity];
                var interval = after.Time - before.Time;
                if (time > after.Time || interval > _maximumGap) return false;
                value = _interpolate(before.Value, after.Value, (time - before.Time) / interval);
                return true;
            }
            return false;
        }

        public void Clear() => _count = 0;
    }
}
