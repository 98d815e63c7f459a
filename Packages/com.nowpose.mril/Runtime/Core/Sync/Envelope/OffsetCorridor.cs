using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Bounds of the offset relative to an estimated line, and lateness of the packets relative to the bounds; in seconds.
    /// Each bound includes the minimum delay of its direction.
    /// </summary>
    sealed class OffsetCorridor
    {
        const double SecondsPerTick = 1e-7;

        readonly int _row;
        double _sumBelow, _sumAbove, _rowBelow, _rowAbove, _slackestBelow, _slackestAbove;

        /// <param name="row">Number of consecutive exchanges in a group. Only the tightest bounds of a group are used.</param>
        public OffsetCorridor(int row)
        {
            _row = row;
            Clear();
        }

        /// <summary>Number of exchanges added.</summary>
        public int Count { get; private set; }

        /// <summary>Maximum of the lower bounds, each relative to the line.</summary>
        public double Lower { get; private set; }

        /// <summary>Smallest upper bound minus the line.</summary>
        public double Upper { get; private set; }

        /// <summary>Mean lateness of the packets relative to the packet with the shortest delay; the larger value of the two directions.</summary>
        public double Lateness => Math.Max(Lower - _sumBelow / Count, _sumAbove / Count - Upper);

        /// <summary>Maximum over all groups: lateness of the least late request of a group, relative to the least late of all requests.</summary>
        public double RowBelow => Lower - _slackestBelow;

        /// <summary>Maximum over all groups: lateness of the least late reply of a group, relative to the least late of all replies.</summary>
        public double RowAbove => _slackestAbove - Upper;

        public void Clear()
        {
            Count = 0;
            _sumBelow = _sumAbove = 0;
            Lower = _rowBelow = _slackestAbove = double.NegativeInfinity;
            Upper = _rowAbove = _slackestBelow = double.PositiveInfinity;
        }

        public void CopyFrom(OffsetCorridor other)
        {
            (Count, Lower, Upper) = (other.Count, other.Lower, other.Upper);
            (_sumBelow, _sumAbove, _rowBelow, _rowAbove) = (other._sumBelow, other._sumAbove, other._rowBelow, other._rowAbove);
            (_slackestBelow, _slackestAbove) = (other._slackestBelow, other._slackestAbove);
        }

        public void Add(in ClockLine line, in OffsetBounds bounds)
        {
            var (below, above) = Residuals(line, bounds);
            Count++;
            _sumBelow += below;
            _sumAbove += above;
            Lower = Math.Max(Lower, below);
            Upper = Math.Min(Upper, above);
            _rowBelow = Math.Max(_rowBelow, below);
            _rowAbove = Math.Min(_rowAbove, above);
            if (Count % _row != 0) return;
            _slackestBelow = Math.Min(_slackestBelow, _rowBelow);
            _slackestAbove = Math.Max(_slackestAbove, _rowAbove);
            _rowBelow = double.NegativeInfinity;
            _rowAbove = double.PositiveInfinity;
        }

        /// <summary>Returns both bounds of an exchange minus the line, s.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static (double Below, double Above) Residuals(in ClockLine line, in OffsetBounds bounds) => (
            Residual(line, bounds.Sent, bounds.Lower), Residual(line, bounds.Received, bounds.Upper));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static double Residual(in ClockLine line, HeadsetTime at, long bound) =>
            (bound - line.Offset.HeadsetMinusControl.Ticks) * SecondsPerTick - ClockTicks.Seconds(at - line.Reference) * line.Skew;
    }
}
