using System;

namespace Nowpose.Session
{
    /// <summary>Errors of the displayed pose and of the uncompensated pose, relative to the true pose from later samples.</summary>
    /// <remarks>The property that returns the value states the unit: mm for the tool, rad or m for a joint.</remarks>
    public readonly struct DisplayedError
    {
        /// <summary>Creates a value for display or replay; the parameters have the meanings of the properties.</summary>
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

        /// <summary>Number of scored frames.</summary>
        public int Frames { get; }

        public double Rms { get; }

        /// <summary>95th percentile, accurate to about 2 %.</summary>
        public double P95 { get; }

        public double HoldRms { get; }

        /// <summary>95th percentile of the error of the uncompensated pose, as accurate as <see cref="P95"/>.</summary>
        public double HoldP95 { get; }

        /// <summary>
        /// 1 − <see cref="Rms"/> ÷ <see cref="HoldRms"/>: 0.8 when a fifth of the error remains, negative when the error has increased. Null
        /// while the robot is at rest and the hold has practically no error.
        /// </summary>
        public double? Reduction { get; }

        /// <summary>
        /// Half-width of the 95 % confidence interval of <see cref="Reduction"/>, from the scatter of the reduction between intervals of about
        /// one second, because neighbouring frames have similar errors. Null when too few intervals contain motion.
        /// </summary>
        public double? ReductionUncertainty { get; }

        /// <summary>RMS of the uncertainty of the true pose, because the motion between two samples is unknown.</summary>
        public double TruthUncertainty { get; }

        /// <summary>
        /// Error that the samples cannot show: RMS of the speed times the error bound of the clock. An error of L_visu does not show in the
        /// samples either, and its size is unknown.
        /// </summary>
        public double ClockUncertainty { get; }

        /// <summary>Returns the same errors with lengths multiplied by <paramref name="factor"/>, for a smaller unit.</summary>
        internal DisplayedError Times(double factor) => new DisplayedError(
            Frames, Rms * factor, P95 * factor, HoldRms * factor, HoldP95 * factor, Reduction, ReductionUncertainty,
            TruthUncertainty * factor, ClockUncertainty * factor);
    }

    /// <summary>The error of one joint between base and tool.</summary>
    public readonly struct JointError
    {
        public JointError(string joint, DisplayedError? error) => (Joint, Error) = (joint, error);

        /// <summary>Name of the joint in the URDF.</summary>
        public string Joint { get; }

        /// <summary>Error in rad, or in m for a prismatic joint; null while unknown.</summary>
        public DisplayedError? Error { get; }
    }
}
