using System;

namespace Nowpose.Latency.Calibration
{
    /// <summary>What marks by eye say of L_visu.</summary>
    readonly struct NudgeResult
    {
        internal NudgeResult(VisualisationLatency visualisation, TimeSpan spread, double offsetMm, int count)
        {
            Visualisation = visualisation;
            Spread = spread;
            OffsetMm = offsetMm;
            Count = count;
        }

        public VisualisationLatency Visualisation { get; }

        /// <summary>
        /// How L_visu of one forward and one backward mark scatters, one standard deviation; never less than an eye that sees
        /// <see cref="NudgeCalibration.EyeMm"/>.
        /// </summary>
        public TimeSpan Spread { get; }

        /// <summary>By how much the robot is drawn too far back along the axis whatever it does, mm: its base is misplaced.</summary>
        public double OffsetMm { get; }

        /// <summary>Marks it is made of, in both directions.</summary>
        public int Count { get; }
    }
}
