using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;

namespace Nowpose.Latency.Calibration
{
    /// <summary>Marks that a user sets by eye, each with the measured speed of the tool; the sign of the speed is the direction.</summary>
    sealed class MarkedNudges
    {
        const double MinSpeedMmPerS = 20;

        /// <summary>Maximum deviation of a mark's speed from the mean, relative to the mean.</summary>
        const double MaxSpeedDeviation = 0.1;

        readonly double _usedVisuMs;
        readonly List<(double OffsetMm, double SpeedMmPerS)> _marks = new List<(double, double)>();

        /// <param name="usedVisuMs">L_visu that was in use when the ghost was drawn, 0 to 500 ms.</param>
        public MarkedNudges(double usedVisuMs) => _usedVisuMs = usedVisuMs;

        public int ForwardCount => _marks.Count(m => m.SpeedMmPerS > 0);

        public int BackwardCount => _marks.Count(m => m.SpeedMmPerS < 0);

        /// <param name="offsetMm">Shift of the ghost along the axis at which the ghost agrees with the robot.</param>
        /// <param name="speedMmPerS">Speed of the tool along the axis, negative for backward motion.</param>
        /// <exception cref="InputException">The speed is too low, or differs from the speed at the previous marks.</exception>
        public void Add(double offsetMm, double speedMmPerS)
        {
            if (!(Math.Abs(speedMmPerS) >= MinSpeedMmPerS))
                throw new InputException(NudgeMessages.TooSlow(speedMmPerS, MinSpeedMmPerS));
            if (_marks.Count > 0 && Math.Abs(Math.Abs(speedMmPerS) - Speed) > MaxSpeedDeviation * Speed)
                throw new InputException(NudgeMessages.OtherSpeed(Math.Abs(speedMmPerS), Speed));
            _marks.Add((offsetMm, speedMmPerS));
        }

        public void Clear() => _marks.Clear();

        /// <exception cref="InputException">A direction has no mark, or the marks result in an impossible L_visu.</exception>
        public NudgeResult Result
        {
            get
            {
                // Without marks, NudgeCalibration reports which direction has no mark, and the speed has no effect.
                var nudge = new NudgeCalibration(_marks.Count == 0 ? MinSpeedMmPerS : Speed, _usedVisuMs);
                foreach (var (offsetMm, speedMmPerS) in _marks)
                {
                    if (speedMmPerS > 0) nudge.AddForward(offsetMm);
                    else nudge.AddBackward(offsetMm);
                }
                return nudge.Result;
            }
        }

        // Both directions have equal weight regardless of their number of marks, because the result is half the difference between the means of the
        // two directions.
        double Speed
        {
            get
            {
                var directions = _marks.GroupBy(m => m.SpeedMmPerS > 0).Select(d => d.Average(m => Math.Abs(m.SpeedMmPerS)));
                return directions.Average();
            }
        }
    }
}
