using System;
using Nowpose.Kinematics;
using Nowpose.Prediction;

namespace Nowpose.Session
{
    /// <summary>How joints are predicted. Immutable, checked once.</summary>
    public sealed class PredictionSettings
    {
        /// <summary>Costs less than 5 % of RMS error, and takes a fifth to a third off the jumps; display.md has the numbers.</summary>
        public const double DefaultBlendMs = 14;

        /// <summary>Beyond, the blend is a latency of its own.</summary>
        const double GreatestBlendMs = 200;

        /// <summary>The paper's choice: quadratic, interpolating.</summary>
        public static readonly PredictionSettings Default = new PredictionSettings();

        /// <param name="predictor">One of <see cref="Predictors.Names"/>.</param>
        /// <param name="horizonCapMs">How far ahead of the newest sample is predicted at most; beyond, the value there stays, marked held.</param>
        /// <param name="maximumGapMs">
        /// A longer pause between two samples ends the history: motion before it says nothing about motion after it.
        /// </param>
        /// <param name="blendMs">
        /// Within which the difference between two sections falls to 1/e when one replaces the other; 0 lets the joint jump.
        /// </param>
        /// <param name="followPlan">Whether joints are shown by the control system's set-points ahead, where it publishes them.</param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public PredictionSettings(
            string predictor = Predictors.Default, double horizonCapMs = 300, double maximumGapMs = 500, double blendMs = DefaultBlendMs,
            bool followPlan = true)
        {
            Predictor = predictor;
            HorizonCap = SettingRange.RequireMs(horizonCapMs, 0, 5000, "horizon cap");
            MaximumGap = SettingRange.RequireMs(maximumGapMs, 1, 60_000, "maximum gap");
            Blend = SettingRange.RequireMs(blendMs, 0, GreatestBlendMs, "blend");
            FollowPlan = followPlan;
            Create(JointLimits.None);
        }

        public string Predictor { get; }
        public TimeSpan HorizonCap { get; }
        public TimeSpan MaximumGap { get; }

        /// <summary>Time constant of <see cref="BlendedPredictor"/>.</summary>
        public TimeSpan Blend { get; }

        /// <summary>Whether the set-points of /joint_trajectory are used.</summary>
        public bool FollowPlan { get; }

        /// <summary>Hold is what the others are compared with: the newest samples as they are, neither blended nor planned.</summary>
        internal bool IsHold => Predictor == "hold";

        /// <summary>A predictor for one joint, bounded by its limits.</summary>
        public IJointPredictor Create(JointLimits limits) => Predictors.Create(Predictor, LimitsOf(limits));

        internal PredictionLimits LimitsOf(JointLimits limits) => new PredictionLimits(
            limits.Lower, limits.Upper, ClockTicks.Seconds(HorizonCap), ClockTicks.Seconds(MaximumGap));
    }
}
