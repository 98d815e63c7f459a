using System.Runtime.CompilerServices;
using Nowpose.Prediction.State;

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

        /// <summary>
        /// Distance from a grid point, in steps, within which a sample counts as lying on it: more than the rounding errors of times and of numbers
        /// of steps, and too short for a visible motion.
        /// </summary>
        public const double Rounding = 1e-6;

        double _start;

        /// <param name="components">Number of components of a position.</param>
        public MotionHistory(int components)
        {
            Components = components;
            Points = new double[Capacity * components];
        }

        /// <summary>Number of components of a position.</summary>
        public int Components { get; }

        /// <summary>Grid step, s.</summary>
        public double Step { get; private set; }

        /// <summary>Grid points since the start; the newest <see cref="Capacity"/> of them are kept.</summary>
        public long Count { get; private set; }

        /// <summary>Ring buffer of the positions at the grid points; the components of a position are adjacent.</summary>
        public double[] Points { get; }

        /// <summary>Clears the history.</summary>
        /// <param name="step">Grid step in s; 0 until the interval of the samples is known.</param>
        /// <param name="start">Time of the first grid point, in s: the time of a sample.</param>
        public void Start(double step, double start = 0) => (Step, _start, Count) = (step, start, 0);

        /// <summary>Adds the grid points up to the sample before the newest one. The motion must still have the samples around these points.</summary>
        public void Add(MotionState motion)
        {
            for (var age = motion.Count - 2; age > 0; age--)
                for (; TimeOf(Count) <= motion.TimeOf(age) + Rounding * Step; Count++) Interpolate(motion, age);
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

        double TimeOf(long index) => _start + index * Step;

        // Cubic Hermite between a sample and the one before it, with slopes of the parabolas through their neighbours.
        void Interpolate(MotionState motion, int age)
        {
            // Before the first sample, the motion is at rest.
            var (x, times, isFirst) = (TimeOf(Count) - motion.TimeOf(age + 1), motion.Times, age + 2 == motion.Count);
            double h0 = isFirst ? Step : times[age + 1] - times[age + 2], h1 = times[age] - times[age + 1], h2 = times[age - 1] - times[age];
            for (int c = 0, place = PlaceOf(Count); c < Components; c++)
            {
                double p1 = motion.PositionOf(age, c), p2 = motion.PositionOf(age + 1, c);
                double d0 = isFirst ? 0 : (p2 - motion.PositionOf(age + 2, c)) / h0, d1 = (p1 - p2) / h1, d2 = (motion.PositionOf(age - 1, c) - p1) / h2;
                var m1 = (d0 * h1 + d1 * h0) / (h0 + h1);
                var m2 = (d1 * h2 + d2 * h1) / (h1 + h2);
                var square = (3 * d1 - 2 * m1 - m2) / h1;
                var cube = (m1 + m2 - 2 * d1) / (h1 * h1);
                Points[place + c] = p2 + x * (m1 + x * (square + x * cube));
            }
        }
    }
}
