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

        const double LeastSpeedShare = 0.01;
        const double LeastLimit = 0.01;
        const double GreatestLimit = 1e6;

        /// <summary>What suits motion nobody has seen before.</summary>
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
        /// <param name="speedShare">What programs use of the URDF's velocity limits, above 0, at most 1: the override.</param>
        /// <param name="accelerationLimit">
        /// rad/s², of revolute joints; infinity where it is not known. Of it and the URDF's the smaller counts. With
        /// <paramref name="jerkLimit"/> moves from rest to rest are predicted by their profile.
        /// </param>
        /// <param name="jerkLimit">rad/s³, of revolute joints; infinity where it is not known.</param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public PredictionSettings(
            string predictor = Predictors.Default, double horizonCapMs = 300, double maximumGapMs = 500, double blendMs = DefaultBlendMs,
            bool followPlan = true, double speedShare = 1, double accelerationLimit = double.PositiveInfinity,
            double jerkLimit = double.PositiveInfinity)
        {
            Predictor = predictor;
            HorizonCap = SettingRange.RequireMs(horizonCapMs, 0, 5000, "horizon cap");
            MaximumGap = SettingRange.RequireMs(maximumGapMs, 1, 60_000, "maximum gap");
            Blend = SettingRange.RequireMs(blendMs, 0, GreatestBlendMs, "blend");
            FollowPlan = followPlan;
            SpeedShare = SettingRange.Require(speedShare, LeastSpeedShare, 1, "speed share", "of the URDF's velocity");
            AccelerationLimit = RequireLimit(accelerationLimit, "acceleration limit", "rad/s²");
            JerkLimit = RequireLimit(jerkLimit, "jerk limit", "rad/s³");
            Create(JointLimits.None);
        }

        public string Predictor { get; }
        public TimeSpan HorizonCap { get; }
        public TimeSpan MaximumGap { get; }

        /// <summary>Time constant within which a new section takes over from the one before; 0: at once.</summary>
        public TimeSpan Blend { get; }

        /// <summary>Whether the set-points of /joint_trajectory are used.</summary>
        public bool FollowPlan { get; }

        /// <summary>Above 0, at most 1.</summary>
        public double SpeedShare { get; }

        /// <summary>rad/s²; infinity where it is not known.</summary>
        public double AccelerationLimit { get; }

        /// <summary>rad/s³; infinity where it is not known.</summary>
        public double JerkLimit { get; }

        /// <summary>Hold is what the others are compared with: the newest samples as they are, neither blended nor planned.</summary>
        internal bool IsHold => Predictor == "hold";

        internal bool FollowsPlans => FollowPlan && !IsHold;

        /// <summary>A predictor for one joint, bounded by its limits.</summary>
        /// <param name="limits">As <see cref="Bounded"/>.</param>
        public JointPredictor Create(in JointLimits limits) =>
            Predictors.Create(Predictor, LimitsOf(limits), IsHold ? 0 : ClockTicks.Seconds(Blend));

        /// <summary>A joint's limits with those of these settings.</summary>
        /// <param name="isRevolute">Whether acceleration and jerk of these settings are meant for it.</param>
        public JointLimits Bounded(in JointLimits limits, bool isRevolute) => new JointLimits(
            limits.Lower, limits.Upper, limits.Velocity * SpeedShare, limits.Effort,
            isRevolute ? Math.Min(limits.Acceleration, AccelerationLimit) : limits.Acceleration,
            isRevolute ? Math.Min(limits.Jerk, JerkLimit) : limits.Jerk,
            isRevolute && double.IsInfinity(limits.Lower) && double.IsInfinity(limits.Upper));

        PredictionLimits LimitsOf(in JointLimits limits) => new PredictionLimits(
            limits.Lower, limits.Upper, ClockTicks.Seconds(HorizonCap), ClockTicks.Seconds(MaximumGap), limits.Velocity,
            limits.Acceleration, limits.Jerk, limits.IsEndless);

        static double RequireLimit(double value, string name, string unit) =>
            double.IsPositiveInfinity(value) ? value : SettingRange.Require(value, LeastLimit, GreatestLimit, name, unit);
    }
}
