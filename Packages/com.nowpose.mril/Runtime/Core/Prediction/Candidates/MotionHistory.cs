using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Keeps two minutes of a joint's motion on a uniform time grid, interpolated from samples at any intervals.</summary>
    /// <remarks>
    /// Indices count grid points since the start and never wrap. The grid ends one sample before the newest sample, so that every
    /// point has samples on both sides. Allocates nothing after construction.
    /// </remarks>
    sealed class MotionHistory
    {
        /// <summary>
        /// Maximum number of stored points: more than two minutes with a sample every 20 ms. The number is a power of two, so that index
        /// operations use a mask instead of thousands of divisions per sample.
        /// </summary>
        public const int Capacity = 8192;

        /// <summary>The grid point of an index is at <c>index &amp; Mask</c> in <see cref="Points"/>.</summary>
        public const int Mask = Capacity - 1;

        /// <summary>
        /// Number of newest grid points that a match must not include, because the spline also needs points after the last point that is read.
        /// </summary>
        public const int Margin = 4;

        /// <summary>Number of samples around a grid point: two on either side determine a cubic.</summary>
        const int Neighbours = 4;

        /// <summary>
        /// Minimum height of a spike: the smaller of the displacements to the sample and back, relative to the maximum displacement in one direction.
        /// When a joint reverses at its maximum speed, the ratio is at most 1; the margin allows for a slightly faster motion.
        /// </summary>
        const double SpikeRatio = 1.3;

        /// <summary>
        /// Distance from a grid point, in steps, within which a sample counts as lying on it: more than the rounding errors of times and of numbers
        /// of steps, and too short for a visible motion.
        /// </summary>
        public const double Rounding = 1e-6;

        readonly double[] _times = new double[Neighbours];
        readonly double[] _positions = new double[Neighbours];
        int _samples;
        double _maxDisplacement;
        double _start;

        /// <summary>Grid step, s.</summary>
        public double Step { get; private set; }

        /// <summary>Grid points since the start; the newest <see cref="Capacity"/> of them are kept.</summary>
        public long Count { get; private set; }

        /// <summary>Ring buffer of the positions at the grid points, for loops over many of them.</summary>
        public double[] Points { get; } = new double[Capacity];

        /// <summary>Position at a grid point, which must be one of the newest <see cref="Capacity"/>.</summary>
        public double this[long index] => Points[(int)index & Mask];

        /// <summary>Clears the history and sets the grid step.</summary>
        /// <param name="step">Grid step in s.</param>
        public void Start(double step)
        {
            Step = step;
            Count = 0;
            _samples = 0;
            _maxDisplacement = 0;
        }

        /// <summary>Adds a sample that is newer than all previous samples.</summary>
        public void Add(double time, double position)
        {
            if (_samples == 0) _start = time;
            else if (!(time > _times[0])) return;
            for (var i = Neighbours - 1; i > 0; i--)
            {
                _times[i] = _times[i - 1];
                _positions[i] = _positions[i - 1];
            }
            _times[0] = time;
            _positions[0] = position;
            if (_samples < Neighbours)
            {
                // Until there are enough samples, the first one is repeated backwards in time.
                for (var i = _samples + 1; i < Neighbours; i++)
                {
                    _times[i] = _times[i - 1] - Step;
                    _positions[i] = _positions[i - 1];
                }
                _samples++;
            }
            if (_samples == Neighbours) ReplaceSpike();
            for (; TimeOf(Count) <= _times[1] + Rounding * Step; Count++) Points[(int)Count & Mask] = Between(TimeOf(Count));
        }

        // A wrong sample would reappear in a forecast whenever the motion repeats.
        void ReplaceSpike()
        {
            double to = _positions[1] - _positions[2], from = _positions[0] - _positions[1];
            var less = Math.Min(Math.Abs(to), Math.Abs(from));
            if (to * from >= 0) _maxDisplacement = Math.Max(_maxDisplacement, less);
            else if (_maxDisplacement > 0 && less > SpikeRatio * _maxDisplacement)
                _positions[1] = _positions[2] + (_positions[0] - _positions[2]) * (_times[1] - _times[2]) / (_times[0] - _times[2]);
        }

        /// <summary>Converts a time to a fractional grid index.</summary>
        public double IndexOf(double time) => (time - _start) / Step;

        /// <summary>Returns the position at a fractional index by a Catmull-Rom spline; it needs two points on either side.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double At(double index)
        {
            var cell = (long)index;
            var (f, i, points) = (index - cell, (int)cell, Points);
            double p0 = points[(i - 1) & Mask], p1 = points[i & Mask], p2 = points[(i + 1) & Mask], p3 = points[(i + 2) & Mask];
            return p1 + 0.5 * f * (p2 - p0 + f * (2 * p0 - 5 * p1 + 4 * p2 - p3 + f * (3 * (p1 - p2) + p3 - p0)));
        }

        /// <summary>Adds the weighted positions at equidistant indices to a table.</summary>
        /// <param name="index">First index, as in <see cref="At"/>.</param>
        /// <param name="step">Interval of the indices.</param>
        /// <param name="offset">Value that is added to each position.</param>
        public void AddTo(double[] table, int start, int count, double index, double step, double weight, double offset)
        {
            for (var k = start; k < start + count; k++, index += step) table[k] += weight * (offset + At(index));
        }

        /// <summary>Returns whether <see cref="At"/> has a position for an index.</summary>
        public bool Covers(double index) => index < Count - 2 && index >= 1 && index >= Count - Capacity + 1;

        double TimeOf(long index) => _start + index * Step;

        // Cubic Hermite between samples 2 and 1, with slopes of the parabolas through their neighbours.
        double Between(double time)
        {
            double h0 = _times[2] - _times[3], h1 = _times[1] - _times[2], h2 = _times[0] - _times[1];
            double d0 = (_positions[2] - _positions[3]) / h0, d1 = (_positions[1] - _positions[2]) / h1, d2 = (_positions[0] - _positions[1]) / h2;
            var m1 = (d0 * h1 + d1 * h0) / (h0 + h1);
            var m2 = (d1 * h2 + d2 * h1) / (h1 + h2);
            var x = time - _times[2];
            var c = (3 * d1 - 2 * m1 - m2) / h1;
            var d = (m1 + m2 - 2 * d1) / (h1 * h1);
            return _positions[2] + x * (m1 + x * (c + x * d));
        }
    }
}
