using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// The bounds of the offset in one direction, measured relative to a curve: the tightness of a bound is its distance from the curve towards the offset.
    /// Index 0 is the newest bound.
    /// </summary>
    /// <remarks>Allocates nothing after construction.</remarks>
    sealed class MeasuredBounds
    {
        /// <summary>Number of bounds in a block. The largest tightness of each block is stored, because many ranges are searched.</summary>
        const int Block = 15;

        readonly int _sign;
        readonly BoundsHistory _history;
        readonly double[] _tightness, _tightest, _lateness;

        /// <param name="sign">1 for the bounds below the offset, from requests; −1 for the bounds above it, from replies.</param>
        /// <param name="capacity">Maximum number of measured bounds.</param>
        public MeasuredBounds(int sign, BoundsHistory history, int capacity)
        {
            (_sign, _history) = (sign, history);
            (_tightness, _tightest, _lateness) = (new double[capacity], new double[capacity / Block + 1], new double[capacity]);
        }

        /// <summary>Number of measured bounds.</summary>
        public int Count { get; private set; }

        /// <summary>Number of bounds in the history.</summary>
        public int All => _history.Count;

        /// <summary>Tightness of a bound, s. Only differences between values are meaningful.</summary>
        public double this[int age] => _tightness[age];

        /// <summary>Returns the largest tightness of the measured bounds in a range. Only differences between values are meaningful.</summary>
        /// <param name="from">Age of the newest bound of the range.</param>
        /// <param name="to">Age of the oldest bound of the range plus 1 (exclusive).</param>
        public double Tightest(int from, int to)
        {
            var firstBlock = (from + Block - 1) / Block;
            var endBlock = to / Block;
            if (firstBlock >= endBlock) return Max(_tightness, from, to);
            var max = Max(_tightest, firstBlock, endBlock);
            // A comparison takes a fraction of the time of Math.Max; the processor predicts the branch.
            for (var i = from; i < firstBlock * Block; i++)
                if (_tightness[i] > max) max = _tightness[i];
            for (var i = endBlock * Block; i < to; i++)
                if (_tightness[i] > max) max = _tightness[i];
            return max;
        }

        /// <summary>Measures the bounds of the history relative to a curve. The newest bound is already corrected by <see cref="MinDelay.Excess"/>.</summary>
        /// <param name="curve">Shape of the offset; its height has no effect.</param>
        public void Measure(OffsetCurve curve)
        {
            Count = Math.Min(_history.Count, _tightness.Length);
            if (Count == 0) return;
            var (newestAt, newest) = BoundOf(_history[0]);
            for (var i = 0; i < Count; i++)
            {
                var (at, bound) = BoundOf(_history[i]);
                _tightness[i] = _sign * (ClockTicks.Seconds(new TimeSpan(bound - newest)) - curve.At(ClockTicks.Seconds(at - newestAt)));
            }
            MeasureBlocks(0, Count);
        }

        public void Clear() => Count = 0;

        /// <summary>Returns the time from the bound of the oldest of the newest exchanges to that of the newest one.</summary>
        public TimeSpan Duration(int exchanges) => _history[0].Received - _history[exchanges - 1].Received;

        /// <summary>Returns the minimum round-trip time of the exchanges in a range, s. A wrong skew has no effect on it.</summary>
        public double MinRoundTrip(int from, int to)
        {
            var min = long.MaxValue;
            for (var i = from; i < to; i++) min = Math.Min(min, _history[i].Upper - _history[i].Lower);
            return ClockTicks.Seconds(new TimeSpan(min));
        }

        /// <summary>Returns a quantile of the lateness in a range relative to a reference, s.</summary>
        public double Quantile(int from, int to, double reference, double share)
        {
            for (var i = from; i < to; i++) _lateness[i - from] = reference - _tightness[i];
            Array.Sort(_lateness, 0, to - from);
            return _lateness[(int)Math.Ceiling(share * (to - from - 1))];
        }

        /// <summary>Moves the bounds in a range towards the offset, in the history too.</summary>
        /// <param name="to">End of the range in the history (exclusive).</param>
        public void Shift(int from, int to, double seconds)
        {
            var ticks = ClockTicks.Span(seconds).Ticks * _sign;
            for (var i = from; i < to; i++)
                _history.Shift(i, _sign > 0 ? ticks : 0, _sign > 0 ? 0 : ticks);
            var end = Math.Min(to, _tightness.Length);
            for (var i = from; i < end; i++) _tightness[i] += seconds;
            MeasureBlocks(from, end);
        }

        // Determines the largest tightness of each block that has an element in a range. An incomplete block at the end is not used.
        void MeasureBlocks(int from, int to)
        {
            for (var start = from / Block * Block; start < to; start += Block)
                _tightest[start / Block] = Max(_tightness, start, Math.Min(start + Block, _tightness.Length));
        }

        static double Max(double[] values, int from, int to)
        {
            var max = double.NegativeInfinity;
            for (var i = from; i < to; i++)
                if (values[i] > max) max = values[i];
            return max;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        (HeadsetTime At, long Bound) BoundOf(in OffsetBounds bounds) =>
            _sign > 0 ? (bounds.Sent, bounds.Lower) : (bounds.Received, bounds.Upper);
    }
}
