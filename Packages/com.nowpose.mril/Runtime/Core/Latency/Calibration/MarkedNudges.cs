using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Nowpose.Latency.Calibration
{
    /// <summary>Marks by eye, each with the speed that was measured with it; the direction is that of the speed.</summary>
    sealed class MarkedNudges
    {
        const double LeastSpeedMmPerS = 20;

        /// <summary>Speeds of a calibration may differ by this part of the mean.</summary>
        const double SameSpeed = 0.1;

        readonly double _toldMs;
        readonly List<(double OffsetMm, double SpeedMmPerS)> _marks = new List<(double, double)>();

        /// <param name="toldMs">L_visu with which the ghost was drawn, 0 to 500 ms.</param>
        public MarkedNudges(double toldMs) => _toldMs = toldMs;

        public int ForwardCount => _marks.Count(m => m.SpeedMmPerS > 0);

        public int BackwardCount => _marks.Count(m => m.SpeedMmPerS < 0);

        /// <param name="offsetMm">By how much the ghost is shifted along the axis where it agrees.</param>
        /// <param name="speedMmPerS">Of the tool along the axis, negative backward.</param>
        /// <exception cref="InputException">Too slow, or a speed that is not that of the marks before.</exception>
        public void Add(double offsetMm, double speedMmPerS)
        {
            if (!(Math.Abs(speedMmPerS) >= LeastSpeedMmPerS))
                throw Fault("nudge: the tool moves at {0:0} mm/s along the axis; mark at {1:0} mm/s or more", speedMmPerS, LeastSpeedMmPerS);
            if (_marks.Count > 0 && Math.Abs(Math.Abs(speedMmPerS) - Speed) > SameSpeed * Speed)
                throw Fault("nudge: the tool moves at {0:0} mm/s, and moved at {1:0} mm/s in the marks before; keep one speed, or clear them",
                    Math.Abs(speedMmPerS), Speed);
            _marks.Add((offsetMm, speedMmPerS));
        }

        public void Clear() => _marks.Clear();

        /// <exception cref="InputException">A direction has no mark, or the marks give no possible L_visu.</exception>
        public NudgeResult Result
        {
            get
            {
                // Without any mark the calibration says which direction lacks one; the speed does not matter then.
                var nudge = new NudgeCalibration(_marks.Count == 0 ? LeastSpeedMmPerS : Speed, _toldMs);
                foreach (var (offsetMm, speedMmPerS) in _marks)
                {
                    if (speedMmPerS > 0) nudge.AddForward(offsetMm);
                    else nudge.AddBackward(offsetMm);
                }
                return nudge.Result;
            }
        }

        // Of both directions alike, however often each was marked: the half difference goes by the mean of the two.
        double Speed
        {
            get
            {
                var directions = _marks.GroupBy(m => m.SpeedMmPerS > 0).Select(d => d.Average(m => Math.Abs(m.SpeedMmPerS)));
                return directions.Average();
            }
        }

        static InputException Fault(string format, params object[] values) =>
            new InputException(string.Format(CultureInfo.InvariantCulture, format, values));
    }
}
