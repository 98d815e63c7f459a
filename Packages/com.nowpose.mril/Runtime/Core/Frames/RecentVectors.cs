using System;

namespace Nowpose.Frames
{
    /// <summary>The newest samples of a vector without a gap between them, newest first.</summary>
    sealed class RecentVectors
    {
        readonly double[] _times;
        readonly Vector3D[] _vectors;
        readonly double _maximumGap;

        /// <param name="capacity">Number of samples to keep.</param>
        /// <param name="maximumGap">Maximum interval between two samples, in s; after a longer one, only the newest sample is kept.</param>
        public RecentVectors(int capacity, double maximumGap)
        {
            _times = new double[capacity];
            _vectors = new Vector3D[capacity];
            _maximumGap = maximumGap;
        }

        public int Count { get; private set; }

        /// <summary>Mean interval between the samples, in s; 0 before the second sample.</summary>
        public double MeanInterval => Count < 2 ? 0 : (_times[0] - _times[Count - 1]) / (Count - 1);

        public double TimeOf(int age) => _times[age];

        public ref readonly Vector3D this[int age] => ref _vectors[age];

        /// <summary>Adds a sample that is newer than all others. If stamps are wrong, its time may still precede their times.</summary>
        public void Add(double time, in Vector3D vector)
        {
            if (Count > 0 && !(Math.Abs(time - _times[0]) <= _maximumGap)) Count = 0;
            Count = Math.Min(Count + 1, _times.Length);
            for (var age = Count - 1; age > 0; age--) (_times[age], _vectors[age]) = (_times[age - 1], _vectors[age - 1]);
            (_times[0], _vectors[0]) = (time, vector);
        }

        public void Clear() => Count = 0;
    }
}
