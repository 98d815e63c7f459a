using System;

namespace Nowpose.Latency.Calibration
{
    /// <summary>L_visu by eye: how far the ghost is to be shifted to agree with the robot at constant speed, forward and backward.</summary>
    /// <remarks>
    /// With e = true L_visu − told L_visu and a base that is misplaced by d, it takes v·e + d forward and −v·e + d backward: half
    /// the difference over the speed is e, and half the sum d. Not thread-safe.
    /// </remarks>
    sealed class NudgeCalibration
    {
        /// <summary>No eye places a ghost better, one standard deviation, mm.</summary>
        public const double EyeMm = 1;

        const double GreatestOffsetMm = 1000;

        readonly double _speedMmPerS, _toldMs;
        Marks _forward, _backward;

        /// <param name="speedMmPerS">Of the tool along the axis, the same in both directions: 1 to 10 000 mm/s.</param>
        /// <param name="toldMs">L_visu with which the ghost was drawn meanwhile, 0 to 500 ms.</param>
        /// <exception cref="InputException">Out of range.</exception>
        public NudgeCalibration(double speedMmPerS, double toldMs)
        {
            _speedMmPerS = SettingRange.Require(speedMmPerS, 1, 10_000, "speed of the tool", "mm/s");
            _toldMs = VisualisationLatency.FromMilliseconds(toldMs).Length.TotalMilliseconds;
        }

        public int ForwardCount => _forward.Count;

        public int BackwardCount => _backward.Count;

        /// <summary>Whether there is a mark in each direction.</summary>
        public bool IsComplete => ForwardCount > 0 && BackwardCount > 0;

        /// <param name="offsetMm">By how much the ghost is shifted along the axis where it agrees, −1000 to 1000 mm.</param>
        /// <exception cref="InputException">Out of range.</exception>
        public void AddForward(double offsetMm) => _forward.Add(Required(offsetMm));

        /// <inheritdoc cref="AddForward"/>
        public void AddBackward(double offsetMm) => _backward.Add(Required(offsetMm));

        /// <exception cref="InputException">A direction has no mark, or the marks give no possible L_visu.</exception>
        public NudgeResult Result
        {
            get
            {
                if (!IsComplete) throw new InputException("nudge: " + (ForwardCount == 0 ? "forward" : "backward") + " has no mark; mark both directions");
                var errorMs = (_forward.Mean - _backward.Mean) / (2 * _speedMmPerS) * 1000;
                var visuMs = SettingRange.Require(Math.Round(_toldMs + errorMs, 4), 0, LatencyProfile.GreatestVisuMs, "nudge: visualisation latency", "ms");
                return new NudgeResult(
                    VisualisationLatency.FromMilliseconds(visuMs), ClockTicks.Span(MarkMm / (Math.Sqrt(2) * _speedMmPerS)),
                    (_forward.Mean + _backward.Mean) / 2, ForwardCount + BackwardCount);
            }
        }

        /// <summary>How one mark scatters, one standard deviation, mm; a mark of its kind alone says nothing of that.</summary>
        double MarkMm
        {
            get
            {
                var freedoms = ForwardCount + BackwardCount - 2;
                return freedoms == 0 ? EyeMm : Math.Max(EyeMm, Math.Sqrt((_forward.Squares + _backward.Squares) / freedoms));
            }
        }

        static double Required(double offsetMm) => SettingRange.Require(offsetMm, -GreatestOffsetMm, GreatestOffsetMm, "nudge: offset", "mm");

        /// <summary>Mean and scatter, mark by mark.</summary>
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
