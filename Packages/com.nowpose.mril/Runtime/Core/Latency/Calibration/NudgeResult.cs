using System;

namespace Nowpose.Latency.Calibration
{
    /// <summary>Result of a calibration of L_visu by eye.</summary>
    readonly struct NudgeResult
    {
        internal NudgeResult(VisualisationLatency visualisation, TimeSpan spread, double offsetMm, int count) =>
            (Visualisation, Spread, OffsetMm, Count) = (visualisation, spread, offsetMm, count);

        public VisualisationLatency Visualisation { get; }

        /// <summary>
        /// Standard deviation of L_visu from one forward and one backward mark. The standard deviation of a mark is assumed to be
        /// <see cref="NudgeCalibration.EyeMm"/> or more.
        /// </summary>
        public TimeSpan Spread { get; }

        /// <summary>Distance by which the drawn robot is too far back along the axis at any speed, mm, because its base is misplaced.</summary>
        public double OffsetMm { get; }

        /// <summary>Number of marks in both directions.</summary>
        public int Count { get; }
    }
}
