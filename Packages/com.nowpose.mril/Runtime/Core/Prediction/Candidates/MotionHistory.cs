using System;
using System.Runtime.CompilerServices;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Keeps the past of one motion for the candidates that compare the present motion with it: the newest samples, and at least two minutes on a uniform time
    /// grid, interpolated from samples at any intervals.
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
        /// Number of newest grid points that a match must not include, because the spline also needs points after the last point that is read.
        /// </summary>
        public const int Margin = 4;

        /// <summary>
        /// Distance from a grid point, in steps, within which a sample counts as lying on it: more than the rounding errors of times and of numbers
        /// of steps, and too short for a visible motion.
        /// </summary>
        public const double Rounding = 1e-6;

        /// <summary>Number of newest samples: more than there are in the window of <see cref="TemplateForecaster"/> at an interval of 20 ms.</summary>
        const int Kept = 24;

        /// <summary>
        /// Minimum number of sampling intervals before the grid starts. Their running mean then determines the grid step. With 4 or 16, the errors
        /// change by at most 0.4 %.
        /// </summary>
        const int MinIntervals = 8;

        /// <summary>Minimum grid step, in s: the capacity then covers two minutes.</summary>
        const double MinStep = 0.02;

        /// <summary>
        /// Maximum gap in the history, in s, even if the limits allow a longer one: the motion in a longer gap cannot be interpolated.
        /// </summary>
        const double MaxGap = 2;

        /// <summary>
        /// Maximum change of the sampling interval, as a factor; a larger change starts a new history. Twice the interval exceeds it. A lost sample
        /// does not, because a gap changes the mean interval by at most a factor of 1.2 (<see cref="SampleTiming"/>).
        /// </summary>
        const double MaxIntervalRatio = 1.6;

        /// <summary>
        /// Minimum height of a spike: the smaller of the displacements to the sample and back, relative to the maximum displacement in one direction.
        /// When a joint reverses at its maximum speed, the ratio is at most 1; the margin allows for a slightly faster motion.
        /// </summary>
        const double SpikeRatio = 1.3;

        readonly double _maximumGap;
        readonly double[] _maxDisplacements;
        double _interval, _start;

        /// <param name="components">Number of components of a position.</param>
        /// <param name="maximumGap">Maximum gap between two samples, in s; a longer gap restarts the history.</param>
        public MotionHistory(int components, double maximumGap)
        {
            (Components, _maximumGap) = (components, Math.Min(maximumGap, MaxGap));
            Points = new double[Capacity * components];
            Newest = new PositionWindow(Kept, components);
            _maxDisplacements = new double[components];
        }

        /// <summary>Number of components of a position.</summary>
        public int Components { get; }

        /// <summary>The newest samples. A single wrong one is replaced when the next one shows it.</summary>
        public PositionWindow Newest { get; }

        /// <summary>Whether there are enough samples for a grid.</summary>
        public bool HasStarted => Step > 0;

        /// <summary>Number of starts of the grid so far. After each start, its indices count from zero again.</summary>
        public int Starts { get; private set; }

        /// <summary>Grid step, s; 0 before the start.</summary>
        public double Step { get; private set; }

        /// <summary>Grid points since the start; the newest <see cref="Capacity"/> of them are kept.</summary>
        public long Count { get; private set; }

        /// <summary>Ring buffer of the positions at the grid points; the components of a position are adjacent.</summary>
        public double[] Points { get; }

        /// <summary>Adds the newest sample, unless another candidate has added it.</summary>
        public void Take(MotionState motion)
        {
            var (time, meanInterval) = (motion.NewestTime, motion.Timing.MeanInterval);
            if (Newest.Count > 0 && !(time > Newest.Times[0])) return;
            if (Newest.Count > 0 && time - Newest.Times[0] > _maximumGap) Reset();
            // A single gap does not change the mean interval enough to restart.
            if (HasStarted && (meanInterval > MaxIntervalRatio * _interval || meanInterval * MaxIntervalRatio < _interval)) Reset();
            Newest.Add(time, motion.Newest);
            for (var c = 0; c < Components && Newest.Count > 2; c++) ReplaceSpike(c);
            if (HasStarted) ExtendTo(age: 1);
            else if (Newest.Count > MinIntervals) Start(meanInterval);
        }

        public void Reset()
        {
            _interval = Step = 0;
            Newest.Clear();
            Array.Clear(_maxDisplacements, 0, Components);
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

        // The grid step is a multiple of the sampling interval, so that samples lie on grid points and need no interpolation.
        void Start(double interval)
        {
            _interval = interval;
            Step = interval * Math.Ceiling(MinStep / interval - Rounding);
            (_start, Count) = (Newest.Times[Newest.Count - 1], 0);
            for (var age = Newest.Count - 2; age > 0; age--) ExtendTo(age);
            Starts++;
        }

        // Adds the grid points up to the sample with this age.
        void ExtendTo(int age)
        {
            for (; TimeOf(Count) <= Newest.Times[age] + Rounding * Step; Count++) Interpolate(age, TimeOf(Count), PlaceOf(Count));
        }

        // A wrong sample would impair the comparisons of the next samples, and would reappear in a forecast whenever the motion repeats.
        void ReplaceSpike(int component)
        {
            var (times, positions) = (Newest.Times, Newest.Positions);
            double newest = positions[component], before = positions[2 * Components + component];
            ref var middle = ref positions[Components + component];
            ref var max = ref _maxDisplacements[component];
            double to = middle - before, from = newest - middle;
            var less = Math.Min(Math.Abs(to), Math.Abs(from));
            if (to * from >= 0) max = Math.Max(max, less);
            else if (max > 0 && less > SpikeRatio * max) middle = before + (newest - before) * (times[1] - times[2]) / (times[0] - times[2]);
        }

        double TimeOf(long index) => _start + index * Step;

        // Cubic Hermite between the sample with this age and the one before it, with slopes of the parabolas through their neighbours.
        void Interpolate(int age, double time, int place)
        {
            var (times, isFirst) = (Newest.Times, age + 2 == Newest.Count);
            // The first sample is repeated backwards in time.
            double h0 = isFirst ? Step : times[age + 1] - times[age + 2], h1 = times[age] - times[age + 1], h2 = times[age - 1] - times[age];
            var x = time - times[age + 1];
            Span<double> newer = Newest[age - 1], after = Newest[age], before = Newest[age + 1], older = Newest[isFirst ? age + 1 : age + 2];
            for (var c = 0; c < Components; c++)
            {
                double p1 = after[c], p2 = before[c];
                double d0 = (p2 - older[c]) / h0, d1 = (p1 - p2) / h1, d2 = (newer[c] - p1) / h2;
                var m1 = (d0 * h1 + d1 * h0) / (h0 + h1);
                var m2 = (d1 * h2 + d2 * h1) / (h1 + h2);
                var square = (3 * d1 - 2 * m1 - m2) / h1;
                var cube = (m1 + m2 - 2 * d1) / (h1 * h1);
                Points[place + c] = p2 + x * (m1 + x * (square + x * cube));
            }
        }
    }
}
