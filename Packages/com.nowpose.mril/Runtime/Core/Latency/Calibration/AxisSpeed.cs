using System;

namespace Nowpose.Latency.Calibration
{
    /// <summary>Estimates the speed of a tool along an axis, and whether it is constant, over the newest 30 frames.</summary>
    /// <remarks>Allocates nothing after construction; not thread-safe.</remarks>
    sealed class AxisSpeed
    {
        const int Window = 30;

        /// <summary>
        /// Maximum difference between the speeds of the two halves of the window. MaxDifference is relative, MaxDifferenceMmPerS is in mm/s; the
        /// larger of the two limits applies.
        /// </summary>
        const double MaxDifference = 0.1, MaxDifferenceMmPerS = 3;

        readonly double[] _seconds = new double[Window], _mm = new double[Window];
        ControlTime _epoch, _newest;
        int _count;

        /// <summary>Speed from a line fit over the window; positive along the axis. Null before 30 frames.</summary>
        public double? MmPerS => _count < Window ? (double?)null : Slope(0, Window);

        /// <summary>Whether the speed is constant within the window.</summary>
        public bool IsConstant
        {
            get
            {
                if (_count < Window) return false;
                var (older, newer) = (Slope(0, Window / 2), Slope(Window / 2, Window / 2));
                return Math.Abs(newer - older) <= Math.Max(MaxDifferenceMmPerS, MaxDifference * Math.Abs(Slope(0, Window)));
            }
        }

        /// <param name="at">Time of the position. A repeated time is ignored; an earlier time restarts the window.</param>
        /// <param name="mm">Position along the axis.</param>
        public void Add(ControlTime at, double mm)
        {
            if (_count > 0 && at == _newest) return;
            if (_count > 0 && at < _newest) Reset();
            if (_count == 0) _epoch = at;
            if (_count == Window)
            {
                Array.Copy(_seconds, 1, _seconds, 0, Window - 1);
                Array.Copy(_mm, 1, _mm, 0, Window - 1);
                _count--;
            }
            _seconds[_count] = ClockTicks.Seconds(at - _epoch);
            _mm[_count++] = mm;
            _newest = at;
        }

        /// <summary>Removes all positions. Call it when the axis or the robot changes.</summary>
        public void Reset() => _count = 0;

        double Slope(int from, int count)
        {
            double meanSeconds = 0, meanMm = 0, across = 0, along = 0;
            for (var i = from; i < from + count; i++)
            {
                meanSeconds += _seconds[i] / count;
                meanMm += _mm[i] / count;
            }
            for (var i = from; i < from + count; i++)
            {
                across += (_seconds[i] - meanSeconds) * (_mm[i] - meanMm);
                along += (_seconds[i] - meanSeconds) * (_seconds[i] - meanSeconds);
            }
            return across / along;
        }
    }
}
