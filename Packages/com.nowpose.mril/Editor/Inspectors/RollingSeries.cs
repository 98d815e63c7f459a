using System;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>The newest values of something over a window of time, oldest first. Allocates nothing after construction.</summary>
    sealed class RollingSeries
    {
        readonly double[] _times;
        readonly float[] _values;
        readonly double _seconds;
        int _first;

        /// <param name="capacity">At most so many values are kept, 2 or more.</param>
        /// <param name="seconds">Length of the window, longer than 0.</param>
        public RollingSeries(int capacity, double seconds)
        {
            if (capacity < 2) throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "capacity must be 2 or more");
            if (!(seconds > 0)) throw new ArgumentOutOfRangeException(nameof(seconds), seconds, "seconds must be more than 0");
            _times = new double[capacity];
            _values = new float[capacity];
            _seconds = seconds;
        }

        public int Count { get; private set; }

        /// <summary>Length of the window in seconds.</summary>
        public double Seconds => _seconds;

        /// <summary>NaN where nothing is known.</summary>
        public float Newest => Count == 0 ? float.NaN : _values[Slot(Count - 1)];

        /// <summary>Seconds, in the clock that <see cref="Add"/> was given.</summary>
        public double TimeAt(int index) => _times[Slot(index)];

        /// <summary>NaN where nothing was known then.</summary>
        public float ValueAt(int index) => _values[Slot(index)];

        /// <param name="time">Seconds, later than the newest; another clock or an earlier time begins the series anew.</param>
        /// <param name="value">Null where nothing is known: a gap in the line.</param>
        public void Add(double time, double? value)
        {
            if (Count > 0 && time < TimeAt(Count - 1)) Clear();
            while (Count > 0 && (Count == _times.Length || TimeAt(0) < time - _seconds)) RemoveFirst();
            var slot = Slot(Count++);
            _times[slot] = time;
            _values[slot] = value.HasValue ? (float)value.Value : float.NaN;
        }

        public void Clear() => _first = Count = 0;

        /// <returns>False where no value is known.</returns>
        public bool TryGetRange(out float least, out float greatest)
        {
            least = float.PositiveInfinity;
            greatest = float.NegativeInfinity;
            for (var i = 0; i < Count; i++)
            {
                var value = ValueAt(i);
                if (float.IsNaN(value)) continue;
                least = Math.Min(least, value);
                greatest = Math.Max(greatest, value);
            }
            return least <= greatest;
        }

        void RemoveFirst()
        {
            _first = (_first + 1) % _times.Length;
            Count--;
        }

        int Slot(int index) => (_first + index) % _times.Length;
    }
}
