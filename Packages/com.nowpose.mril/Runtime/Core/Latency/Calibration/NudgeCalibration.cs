using System;
using Nowpose.Messages;

namespace Nowpose.Latency.Calibration
{
    /// <summary>
    /// Calibrates L_visu by eye, from the shifts at which the ghost agrees with the robot in forward and backward motion at constant speed.
    /// </summary>
    /// <remarks>
    /// With e = true L_visu − L_visu in use, and a base that is misplaced by d, the shift is v·e + d forward and −v·e + d
    /// backward. Half the difference divided by the speed v is e, and half the sum is d. Not thread-safe.
    /// </remarks>
    sealed class NudgeCalibration
    {
        /// <summary>Minimum standard deviation of a mark by eye, mm.</summary>
        public const double EyeMm = 1;

        const double MaxOffsetMm = 1000;

        readonly double _speedMmPerS, _usedVisuMs;
        Marks _forward, _backward;

        /// <param name="speedMmPerS">Speed of the tool along the axis, the same in both directions: 1 to 10 000 mm/s.</param>
        /// <param name="usedVisuMs">L_visu that was in use when the ghost was drawn, 0 to 500 ms.</param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public NudgeCalibration(double speedMmPerS, double usedVisuMs)
        {
            _speedMmPerS = SettingRange.Require(speedMmPerS, 1, 10_000, SettingNames.ToolSpeed, "mm/s");
            _usedVisuMs = VisualisationLatency.FromMilliseconds(usedVisuMs).Length.TotalMilliseconds;
        }

        public int ForwardCount => _forward.Count;

        public int BackwardCount => _backward.Count;

        /// <summary>Whether there is a mark in each direction.</summary>
        public bool IsComplete => ForwardCount > 0 && BackwardCount > 0;

        /// <param name="offsetMm">Shift of the ghost along the axis at which the ghost agrees with the robot, −1000 to 1000 mm.</param>
        /// <exception cref="InputException">The shift is out of range.</exception>
        public void AddForward(double offsetMm) => _forward.Add(Required(offsetMm));

        /// <inheritdoc cref="AddForward"/>
        public void AddBackward(double offsetMm) => _backward.Add(Required(offsetMm));

        /// <exception cref="InputException">A direction has no mark, or the marks result in an impossible L_visu.</exception>
        public NudgeResult Result
        {
            get
            {
                if (!IsComplete) throw new InputException(NudgeMessages.NoMark(ForwardCount == 0));
                var errorMs = (_forward.Mean - _backward.Mean) / (2 * _speedMmPerS) * 1000;
                var visuMs = SettingRange.Require(
                    Math.Round(_usedVisuMs + errorMs, 4), 0, LatencyProfile.MaxVisuMs, "nudge: visualisation latency", "ms");
                return new NudgeResult(
                    VisualisationLatency.FromMilliseconds(visuMs), ClockTicks.Span(MarkMm / (Math.Sqrt(2) * _speedMmPerS)),
                    (_forward.Mean + _backward.Mean) / 2, ForwardCount + BackwardCount);
            }
        }

        /// <summary>Standard deviation of one mark, mm; <see cref="EyeMm"/> with a single mark in each direction.</summary>
        double MarkMm
        {
            get
            {
                var freedoms = ForwardCount + BackwardCount - 2;
                return freedoms == 0 ? EyeMm : Math.Max(EyeMm, Math.Sqrt((_forward.Squares + _backward.Squares) / freedoms));
            }
        }

        static double Required(double offsetMm) => SettingRange.Require(offsetMm, -MaxOffsetMm, MaxOffsetMm, "nudge: offset", "mm");

        /// <summary>Running mean and sum of squared deviations.</summary>
        struct Marks
        {
            public int Count;
            public double Mean, Squares;

            public void Add(double offset)
            {
                Count++;
                var step = offset - Mean;
                Mean += step / Count;
                Squares += step * (offset - Mean);
            }
        }
    }
}
