using System;

namespace Nowpose.Session
{
    /// <summary>How far what was displayed was from the truth that later samples told, and how far the uncompensated hold would have been.</summary>
    /// <remarks>Lengths in the unit that the property says it is in: mm for the tool, rad or m for a joint.</remarks>
    public readonly struct DisplayedError
    {
        /// <summary>For whoever shows or replays one; each value as its property says.</summary>
        public DisplayedError(
            int frames, double rms, double p95, double holdRms, double holdP95, double? reduction, double? reductionUncertainty,
            double truthUncertainty, double clockUncertainty)
        {
            Frames = frames;
            Rms = rms;
            P95 = p95;
            HoldRms = holdRms;
            HoldP95 = holdP95;
            Reduction = reduction;
            ReductionUncertainty = reductionUncertainty;
            TruthUncertainty = truthUncertainty;
            ClockUncertainty = clockUncertainty;
        }

        /// <summary>Frames that could be judged.</summary>
        public int Frames { get; }

        public double Rms { get; }

        /// <summary>Below which 95 % of the frames lie, to about 2 %.</summary>
        public double P95 { get; }

        public double HoldRms { get; }

        /// <summary>As <see cref="P95"/>.</summary>
        public double HoldP95 { get; }

        /// <summary>
        /// 1 − <see cref="Rms"/> ÷ <see cref="HoldRms"/>: 0.8 when a fifth of the error is left, negative when it has grown. Null
        /// while nothing moves, for then there is no error to reduce.
        /// </summary>
        public double? Reduction { get; }

        /// <summary>
        /// Half-width of the 95 % confidence interval of <see cref="Reduction"/>, from how it differs between stretches of about a
        /// second (neighbouring frames err alike and count for little more than one). Null when too few of them hold motion.
        /// </summary>
        public double? ReductionUncertainty { get; }

        /// <summary>RMS of what the truth itself may be off, since nothing tells how the robot moved between two samples.</summary>
        public double TruthUncertainty { get; }

        /// <summary>
        /// What the samples cannot see: RMS of the speed times the bound of the clock's error. An error of L_visu hides likewise,
        /// and nobody knows how large it is.
        /// </summary>
        public double ClockUncertainty { get; }

        /// <summary>The same in a unit that is so many times smaller.</summary>
        internal DisplayedError Times(double factor) => new DisplayedError(
            Frames, Rms * factor, P95 * factor, HoldRms * factor, HoldP95 * factor, Reduction, ReductionUncertainty,
            TruthUncertainty * factor, ClockUncertainty * factor);
    }
}
