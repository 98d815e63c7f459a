using System;
using System.Runtime.CompilerServices;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Keeps at least two minutes of a motion on a uniform time grid, interpolated from samples at any intervals.</summary>
    /// <remarks>
    /// Indices count grid points since the start and never wrap. The grid ends one sample before the newest sample, so that every
    /// point has samples on both sides. A position has one component (a joint) or several (a vector).
    /// </remarks>
    sealed class MotionHistory
    {
        /// <summary>
        /// Maximum number of stored points: more than two minutes with a sample every 20 ms. The number is a power of two, so that index
        /// operations use a mask instead of thousands of divisions per sample.
        /// </summary>
        public const int Capacity = 8192;

        const int Mask = Capacity - 1;

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

        readonly PositionWindow _newest;
        readonly double[] _maxDisplacements;
        double _start;

        /// <param name="components">Number of components of a position.</param>
        public MotionHistory(int components)
        {
            Components = components;
            Points = new double[Capacity * components];
            _newest = new PositionWindow(Neighbours, components);
            _maxDisplacements = new double[components];
        }

        /// <summary>Number of components of a position.</summary>
        public int Components { get; }

        /// <summary>Grid step, s.</summary>
        public double Step { get; private set; }

        /// <summary>Grid points since the start; the newest <see cref="Capacity"/> of them are kept.</summary>
        public long Count { get; private set; }

        /// <summary>Ring buffer of the positions at the grid points; the components of a position are adjacent.</summary>
        public double[] Points { get; }

        /// <summary>Position of the sample before the newest one; interpolated if the sample was wrong.</summary>
        public ReadOnlySpan<double> Previous => _newest[1];

        /// <summary>Clears the history and sets the grid step.</summary>
        /// <param name="step">Grid step in s.</param>
        public void Start(double step)
        {
            Step = step;
            Count = 0;
            _newest.Clear();
            Array.Clear(_maxDisplacements, 0, Components);
        }

        /// <summary>Adds a sample that is newer than all previous samples.</summary>
        /// <param name="position">One number per component.</param>
        public void Add(double time, ReadOnlySpan<double> position)
        {
            if (_newest.Count == 0)
            {
                _start = time;
                // Until there are enough samples, the first one is repeated backwards in time.
                for (var i = Neighbours - 1; i > 0; i--) _newest.Add(time - i * Step, position);
            }
            else if (!(time > _newest.Times[0])) return;
            _newest.Add(time, position);
            for (var c = 0; c < Components; c++) ReplaceSpike(c);
            for (; TimeOf(Count) <= _newest.Times[1] + Rounding * Step; Count++) Interpolate(TimeOf(Count), PlaceOf(Count));
        }

        /// <summary>Returns the place of a grid point in <see cref="Points"/>. The point must be one of the newest <see cref="Capacity"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int PlaceOf(long index) => ((int)index & Mask) * Components;

        /// <summary>Converts a time to a fractional grid index.</summary>
        public double IndexOf(double time) => (time - _start) / Step;

        /// <summary>Returns a component of the position at a fractional index, by a Catmull-Rom spline; it needs two points on either side.</summary>
        public double At(double index, int component)
        {
            var cell = (long)index;
            var f = index - cell;
            double p0 = Points[PlaceOf(cell - 1) + component], p1 = Points[PlaceOf(cell) + component];
            double p2 = Points[PlaceOf(cell + 1) + component], p3 = Points[PlaceOf(cell + 2) + component];
            return p1 + 0.5 * f * (p2 - p0 + f * (2 * p0 - 5 * p1 + 4 * p2 - p3 + f * (3 * (p1 - p2) + p3 - p0)));
        }

        /// <summary>Returns whether there is a position at an index.</summary>
        public bool Covers(double index) => index < Count - 2 && index >= 1 && index >= Count - Capacity + 1;

        // A wrong sample would reappear in a forecast whenever the motion repeats.
        void ReplaceSpike(int component)
        {
            var (times, positions) = (_newest.Times, _newest.Positions);
            double newest = positions[component], before = positions[2 * Components + component];
            ref var middle = ref positions[Components + component];
            ref var max = ref _maxDisplacements[component];
            double to = middle - before, from = newest - middle;
            var less = Math.Min(Math.Abs(to), Math.Abs(from));
            if (to * from >= 0) max = Math.Max(max, less);
            else if (max > 0 && less > SpikeRatio * max) middle = before + (newest - before) * (times[1] - times[2]) / (times[0] - times[2]);
        }

        double TimeOf(long index) => _start + index * Step;

        // Cubic Hermite between samples 2 and 1, with slopes of the parabolas through their neighbours.
        void Interpolate(double time, int place)
        {
            var (times, positions) = (_newest.Times, _newest.Positions);
            double h0 = times[2] - times[3], h1 = times[1] - times[2], h2 = times[0] - times[1], x = time - times[2];
            for (var c = 0; c < Components; c++)
            {
                double p1 = positions[Components + c], p2 = positions[2 * Components + c];
                double d0 = (p2 - positions[3 * Components + c]) / h0, d1 = (p1 - p2) / h1, d2 = (positions[c] - p1) / h2;
                var m1 = (d0 * h1 + d1 * h0) / (h0 + h1);
                var m2 = (d1 * h2 + d2 * h1) / (h1 + h2);
                var square = (3 * d1 - 2 * m1 - m2) / h1;
                var cube = (m1 + m2 - 2 * d1) / (h1 * h1);
                Points[place + c] = p2 + x * (m1 + x * (square + x * cube));
            }
        }
    }
}
