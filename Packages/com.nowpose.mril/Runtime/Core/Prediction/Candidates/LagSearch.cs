using System;
using System.Numerics;
using System.Runtime.InteropServices;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Finds how long ago the motion was the same as now: the lags, in whole grid steps, at which the past motion is most similar to the present
    /// motion.
    /// </summary>
    /// <remarks>
    /// For every lag k it sums the squared differences x(n) − x(n−k) of all components with exponential forgetting, one addition per lag, component
    /// and compared grid point. The last half second therefore counts most, which distinguishes one dwell from another. The positions of
    /// a continuous joint are unwrapped, so a cycle that ends one or more turns away from its start is not recognised.
    /// </remarks>
    sealed class LagSearch
    {
        /// <summary>
        /// Number of best lags. With only the best one, the errors are 0.5 % (recordings) and 2.9 % (simulated) larger.
        /// </summary>
        public const int Kept = 3;

        /// <summary>
        /// Time constant of the exponential forgetting in the sums, in s: the last half second has 86 % of the weight, which distinguishes one dwell
        /// from another.
        /// </summary>
        const double Forgetting = 0.25;

        /// <summary>Maximum lag, in s: cycles of up to two minutes.</summary>
        const double MaxLag = 120;

        /// <summary>
        /// Maximum step between successive lags, in s, but at least one grid step; <see cref="MotionOverlay"/> finds the exact lag near them. With
        /// 0.1 s, the error of an exact repetition at a sampling interval of 50 ms is three times as large.
        /// </summary>
        const double LagStep = 0.06;

        /// <summary>
        /// Rounded down to whole grid steps, the step is still more than half of <see cref="LagStep"/>, so there are at most twice as many lags.
        /// </summary>
        const int MaxLags = (int)(2 * MaxLag / LagStep) + 1;

        /// <summary>
        /// Interval between the compared grid points, in s; each requires a pass over all lags. With 0.15 and 0.25 s, the errors are up to 0.5 %
        /// larger.
        /// </summary>
        const double CompareInterval = 0.2;

        /// <summary>Number of lags that are tested together for a low cost: two vectors of four.</summary>
        const int Block = 8;

        /// <summary>
        /// Added to each cost at each comparison, so that costs do not become subnormal: arithmetic with subnormal numbers is many times slower.
        /// </summary>
        const float MinCost = 1e-30f;

        readonly MotionHistory _history;

        // Costs of the lags, preceded by one infinite cost, which is never a minimum. Element i belongs to the lag minLag + (i − 1) · _step.
        readonly float[] _costs = new float[(MaxLags / Block + 1) * Block];
        readonly float[] _lagCosts = new float[Kept];

        // Positions of the history relative to its first position. Grid points that are one lag step apart are adjacent in a row. Each row is a ring
        // buffer with the newest point first. A pass over the lags therefore reads adjacent elements, and only a quarter to a tenth of the memory
        // that it would read in the history. The histories of many joints together exceed the processor's cache. The rows of a component follow those of
        // the previous component.
        readonly float[] _rows;
        int _rowLength;

        // Position of each component at the first and at the newest grid point; the newest is relative to the first.
        readonly double[] _origins;
        readonly float[] _positions;
        long _taken;

        // Whether a component has ever differed from its first position. The others are the same at all lags.
        readonly bool[] _varies;

        // _step: grid steps between successive lags. _stride: grid steps between successive compared points. The forgetting factor is per comparison.
        int _step, _stride;
        double _forgettingFactor;

        public LagSearch(MotionHistory history)
        {
            _history = history;
            _rows = new float[history.Components * MotionHistory.Capacity];
            _origins = new double[history.Components];
            _positions = new float[history.Components];
            _varies = new bool[history.Components];
        }

        /// <summary>The best lags, the best first. Only the first <see cref="Count"/> elements are valid.</summary>
        public int[] Lags { get; } = new int[Kept];

        public int Count { get; private set; }

        /// <summary>Discards all costs and adopts the grid step of the history. Call it after the history has been restarted.</summary>
        public void Start()
        {
            Array.Clear(_costs, 0, _costs.Length);
            _costs[0] = float.PositiveInfinity;
            Array.Clear(_varies, 0, _varies.Length);
            _taken = 0;
            Count = 0;
            if (!(_history.Step > 0)) return;
            _step = Math.Max(1, (int)(LagStep / _history.Step + MotionHistory.Rounding));
            _rowLength = MotionHistory.Capacity / _step;
            _stride = (int)Math.Ceiling(CompareInterval / _history.Step - MotionHistory.Rounding);
            _forgettingFactor = Math.Exp(-_stride * _history.Step / Forgetting);
        }

        /// <summary>Adds the new grid points of the history.</summary>
        /// <param name="minLag">Minimum lag in grid steps; smaller lags would compare the motion with itself.</param>
        public void Update(int minLag)
        {
            for (; _taken < _history.Count; _taken++)
            {
                Take(_taken);
                if (_taken % _stride == 0 && _taken >= minLag) Compare(_taken, minLag);
            }
        }

        void Take(long point)
        {
            for (int c = 0, from = _history.PlaceOf(point), to = PlaceOf(point); c < _positions.Length; c++, to += MotionHistory.Capacity)
            {
                var position = _history.Points[from + c];
                if (point == 0) _origins[c] = position;
                // The squares of larger distances could overflow.
                _rows[to] = _positions[c] = (float)Math.Max(-JointSample.MaxMagnitude, Math.Min(JointSample.MaxMagnitude, position - _origins[c]));
                _varies[c] |= _positions[c] != 0;
            }
        }

        int PlaceOf(long point) => (int)(point % _step) * _rowLength + _rowLength - 1 - (int)(point / _step % _rowLength);

        // Adds the squared difference between the newest position and the position one lag earlier to the cost of each lag, and finds the best local
        // minima.
        void Compare(long newest, int minLag)
        {
            var longest = (int)Math.Min(Math.Min(MaxLag / _history.Step, MotionHistory.Capacity - 1), newest);
            var lags = (longest - minLag) / _step + 1;
            var place = PlaceOf(newest - minLag);
            var start = place - place % _rowLength;
            // The row is a ring buffer, so the earliest positions are at its start.
            var first = Math.Min(lags, start + _rowLength - place);
            var (forgettingFactor, min) = ((float)_forgettingFactor, MinCost);
            for (int c = 0, row = 0; c < _positions.Length; c++, row += MotionHistory.Capacity)
            {
                if (!_varies[c]) continue;
                AddSquares(_costs.AsSpan(1, first), _rows.AsSpan(row + place, first), _positions[c], forgettingFactor, min);
                AddSquares(_costs.AsSpan(1 + first, lags - first), _rows.AsSpan(row + start, lags - first), _positions[c], forgettingFactor, min);
                (forgettingFactor, min) = (1, 0);
            }
            FindMinima(lags, minLag, (int)Math.Min(newest, MotionHistory.Capacity) - MotionHistory.Margin);
        }

        // Computing with vectors of four takes a quarter of the time.
        static void AddSquares(Span<float> costs, Span<float> positions, float position, float forgettingFactor, float min)
        {
            var vectors = MemoryMarshal.Cast<float, Vector4>(costs);
            var others = MemoryMarshal.Cast<float, Vector4>(positions);
            Vector4 vector = new Vector4(position), factor = new Vector4(forgettingFactor), mins = new Vector4(min);
            for (var i = 0; i < vectors.Length; i++)
            {
                ref var cost = ref vectors[i];
                var difference = vector - others[i];
                cost = factor * cost + difference * difference + mins;
            }
            for (var i = vectors.Length * 4; i < costs.Length; i++)
            {
                var difference = position - positions[i];
                costs[i] = forgettingFactor * costs[i] + difference * difference + min;
            }
        }

        /// <summary>
        /// Finds the lags with the smallest costs among the local minima, except the first lag, which has no lower neighbour.
        /// </summary>
        /// <param name="lags">Number of lags.</param>
        /// <param name="covered">First lag, in grid steps, that the history does not cover any more: the lag after a minimum must be smaller.</param>
        void FindMinima(int lags, int minLag, int covered)
        {
            Count = 0;
            var (costs, last) = (_costs, Math.Min(lags - 1, (covered - 1 - minLag) / _step));
            var (worst, worsts) = (float.PositiveInfinity, new Vector4(float.PositiveInfinity));
            var vectors = MemoryMarshal.Cast<float, Vector4>(costs);
            for (int start = 0, block = 0; start <= last; start += Block, block += Block / 4)
            {
                // Skips a block without a cost below those that are kept, because most lags have a higher cost.
                if (Vector4.Min(Vector4.Min(vectors[block], vectors[block + 1]), worsts) == worsts) continue;
                var end = Math.Min(last, start + Block - 1);
                for (var i = Math.Max(2, start); i <= end; i++)
                {
                    if (!(costs[i] < costs[i + 1] && costs[i] <= costs[i - 1] && costs[i] < worst)) continue;
                    Keep(minLag + (i - 1) * _step, costs[i]);
                    if (Count == Kept) worst = _lagCosts[Kept - 1];
                }
                worsts = new Vector4(worst);
            }
        }

        void Keep(int lag, float cost)
        {
            if (Count < Kept) Count++;
            var place = Count - 1;
            for (; place > 0 && cost < _lagCosts[place - 1]; place--) (Lags[place], _lagCosts[place]) = (Lags[place - 1], _lagCosts[place - 1]);
            (Lags[place], _lagCosts[place]) = (lag, cost);
        }
    }
}
