using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Stores the newest values of a quantity within a time window, oldest first. Allocates only at construction.</summary>
    sealed class RollingSeries
    {
        readonly double[] _times;
        readonly float[] _values;
        readonly double _seconds;
        int _first;

        /// <param name="capacity">Maximum number of values, at least 2.</param>
        /// <param name="seconds">Length of the window in s, more than 0.</param>
        public RollingSeries(int capacity, double seconds)
        {
            if (capacity < 2) throw new ArgumentOutOfRangeException(nameof(capacity), capacity, InspectorTexts.Capacity);
            if (!(seconds > 0)) throw new ArgumentOutOfRangeException(nameof(seconds), seconds, InspectorTexts.Seconds);
            _times = new double[capacity];
            _values = new float[capacity];
            _seconds = seconds;
        }

        public int Count { get; private set; }

        /// <summary>Length of the window, in s.</summary>
        public double Seconds => _seconds;

        /// <summary>The newest value; NaN if it is unknown.</summary>
        public float Newest => Count == 0 ? float.NaN : _values[Slot(Count - 1)];

        /// <summary>Returns the time of the value at an index, in s, as passed to <see cref="Add"/>.</summary>
        public double TimeAt(int index) => _times[Slot(index)];

        /// <summary>Returns the value at an index; NaN if it was unknown.</summary>
        public float ValueAt(int index) => _values[Slot(index)];

        /// <summary>Adds a value, and removes the values that are no longer in the window.</summary>
        /// <param name="time">Time in s. A time before the newest time, for example after a change of the clock, clears the series first.</param>
        /// <param name="value">The value; null if it is unknown, which leaves a gap in the line.</param>
        public void Add(double time, double? value)
        {
            if (Count > 0 && time < TimeAt(Count - 1)) Clear();
            while (Count > 0 && (Count == _times.Length || TimeAt(0) < time - _seconds)) RemoveFirst();
            var slot = Slot(Count++);
            _times[slot] = time;
            _values[slot] = value.HasValue ? (float)value.Value : float.NaN;
        }

        public void Clear() => _first = Count = 0;

        /// <summary>Returns the range of the known values.</summary>
        /// <returns>False if no value is known.</returns>
        public bool TryGetRange(out float min, out float max)
        {
            min = float.PositiveInfinity;
            max = float.NegativeInfinity;
            for (var i = 0; i < Count; i++)
            {
                var value = ValueAt(i);
                if (float.IsNaN(value)) continue;
                min = Math.Min(min, value);
                max = Math.Max(max, value);
            }
            return min <= max;
        }

        void RemoveFirst()
        {
            _first = (_first + 1) % _times.Length;
            Count--;
        }

        int Slot(int index) => (_first + index) % _times.Length;
    }
}
