using System;
using System.Runtime.CompilerServices;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Keeps the past of one motion for the candidates that compare the present motion with it: at least two minutes on a uniform time grid, from the
    /// curve through the samples (<see cref="SampleCurve"/>).
    /// </summary>
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
        /// Number of first points that are repeated after the end of the ring buffer, so that the four points that a spline reads are adjacent.
        /// </summary>
        const int Repeated = 3;

        /// <summary>
        /// Number of newest grid points that a match must not include, because the spline also needs points after the last point that is read.
        /// </summary>
        public const int Margin = 4;

        /// <summary>
        /// Distance from a grid point, in steps, within which a sample counts as lying on it: more than the rounding errors of times and of numbers
        /// of steps, and too short for a visible motion.
        /// </summary>
        public const double Rounding = 1e-6;

        /// <summary>
        /// Minimum number of sampling intervals before the grid starts. Their running mean then determines the grid step. With 4 or 16, the errors
        /// change by at most 0.4 %.
        /// </summary>
        const int MinIntervals = 8;

        /// <summary>Minimum grid step, in s: the capacity then covers two minutes.</summary>
        const double MinStep = 0.02;

        /// <summary>
        /// Maximum change of the sampling interval, as a factor; a larger change starts a new history. Twice the interval exceeds it. A lost sample
        /// does not, because a gap changes the mean interval by at most a factor of 1.2 (<see cref="SampleTiming"/>).
        /// </summary>
        const double MaxIntervalRatio = 1.6;

        double _newestTime = double.NegativeInfinity, _interval, _start;

        // Number of samples since the last gap or change of the interval, until the grid starts.
        int _samples;

        public MotionHistory(int components) => (Components, Points) = (components, new double[(Capacity + Repeated) * components]);

        public int Components { get; }

        /// <summary>Whether there are enough samples for a grid.</summary>
        public bool HasStarted => Step > 0;

        /// <summary>Number of starts of the grid so far. After each start, its indices count from zero again.</summary>
        public int Starts { get; private set; }

        /// <summary>Grid step, s; 0 before the start.</summary>
        public double Step { get; private set; }

        /// <summary>Grid points since the start; the newest <see cref="Capacity"/> of them are kept.</summary>
        public long Count { get; private set; }

        /// <summary>Minimum index with a position. A spline needs a point before it.</summary>
        public long First => Math.Max(1, Count - Capacity + 1);

        /// <summary>Index below which there are positions. A spline needs two points after them.</summary>
        public long End => Count - 2;

        /// <summary>
        /// Ring buffer of the positions at the grid points; the components of a position are adjacent. Each point is followed by the next three.
        /// </summary>
        public double[] Points { get; }

        /// <summary>Adds the newest sample, unless another candidate has added it. A gap between two samples restarts the history.</summary>
        public void Take(MotionState motion)
        {
            if (motion.NewestTime == _newestTime) return;
            _newestTime = motion.NewestTime;
            if (motion.Count == 1 || (HasStarted && !Continues(motion.Timing))) (_samples, Step) = (0, 0);
            if (HasStarted) ExtendTo(motion, age: 1);
            // The motion may have left a wrong sample out.
            else if (++_samples > MinIntervals && motion.Count > MinIntervals) Start(motion);
        }

        public void Reset() => (_newestTime, _samples, Step) = (double.NegativeInfinity, 0, 0);

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
            var (points, n, i) = (Points, Components, PlaceOf(cell - 1) + component);
            double p0 = points[i], p1 = points[i + n], p2 = points[i + 2 * n], p3 = points[i + 3 * n];
            return p1 + 0.5 * f * (p2 - p0 + f * (2 * p0 - 5 * p1 + 4 * p2 - p3 + f * (3 * (p1 - p2) + p3 - p0)));
        }

        /// <summary>Returns whether there is a position at an index.</summary>
        public bool Covers(double index) => index >= First && index < End;

        // Whether the samples have about the same interval, without a gap that is longer than the history. A single lost sample does not change the mean
        // interval enough to restart.
        bool Continues(SampleTiming timing) => timing.MeanInterval <= MaxIntervalRatio * _interval && timing.MeanInterval * MaxIntervalRatio >= _interval
            && timing.Interval < Capacity * Step;

        // The grid step is a multiple of the sampling interval, so that samples lie on grid points and need no interpolation.
        void Start(MotionState motion)
        {
            _interval = motion.Timing.MeanInterval;
            Step = _interval * Math.Ceiling(MinStep / _interval - Rounding);
            (_start, Count) = (motion.NewestTime + motion.Times[MinIntervals], 0);
            for (var age = MinIntervals - 1; age > 0; age--) ExtendTo(motion, age);
            Starts++;
        }

        // Adds the grid points up to the sample with this age.
        void ExtendTo(MotionState motion, int age)
        {
            var end = motion.NewestTime + motion.Times[age] + Rounding * Step;
            for (var time = TimeOf(Count); time <= end; time = TimeOf(++Count)) Interpolate(motion, time - motion.NewestTime, PlaceOf(Count));
        }

        double TimeOf(long index) => _start + index * Step;

        void Interpolate(MotionState motion, double ahead, int place)
        {
            for (var c = 0; c < Components; c++, place++)
            {
                Points[place] = motion.Newest[c] + new SampleCurve(motion, c).At(ahead);
                if (place < Repeated * Components) Points[Capacity * Components + place] = Points[place];
            }
        }
    }
}
