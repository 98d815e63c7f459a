using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;

namespace Nowpose.Session
{
    /// <summary>Settings of the joint prediction. Immutable; validated by the constructor.</summary>
    public sealed class PredictionSettings
    {
        /// <summary>Default blend time. Increases the RMS error by less than 5 % and reduces jumps by 20 to 33 %; see display-reference.md.</summary>
        public const double DefaultBlendMs = 14;

        /// <summary>Maximum blend time, ms. A longer blend would itself add latency.</summary>
        const double MaxBlendMs = 200;

        /// <summary>Minimum fraction of the velocity limits: one percent, because controllers set the override in whole percent.</summary>
        const double MinSpeedShare = 0.01;

        /// <summary>
        /// Range of acceleration and jerk limits, in rad/s² and rad/s³: wider than those of any robot, so values outside are input errors.
        /// </summary>
        const double MinLimit = 0.01, MaxLimit = 1e6;

        /// <summary>Settings for motion that is not known in advance.</summary>
        public static readonly PredictionSettings Default = new PredictionSettings();

        /// <param name="predictor">One of <see cref="Predictors.Names"/>.</param>
        /// <param name="horizonCapMs">Maximum prediction beyond the newest sample, ms; after it, the last value is kept and marked as held.</param>
        /// <param name="maximumGapMs">
        /// Maximum interval between two samples of the history, ms. Samples before a longer interval are not used for a prediction.
        /// </param>
        /// <param name="blendMs">
        /// Time in which the difference between an old and a new section decays to 1/e, ms. With 0, the joint jumps to the new section.
        /// </param>
        /// <param name="followPlan">Whether to use the control system's future set-points if it publishes them.</param>
        /// <param name="speedShare">Fraction of the URDF's velocity limits that programs use (the override), above 0, at most 1.</param>
        /// <param name="accelerationLimit">
        /// Acceleration limit for revolute joints, rad/s²; infinity if unknown. The smaller of this limit and the URDF's limit applies. With this
        /// limit and <paramref name="jerkLimit"/>, moves from rest to rest are predicted by their motion profile.
        /// </param>
        /// <param name="jerkLimit">Jerk limit for revolute joints, rad/s³; infinity if unknown.</param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public PredictionSettings(
            string predictor = Predictors.Default, double horizonCapMs = 300, double maximumGapMs = 500, double blendMs = DefaultBlendMs,
            bool followPlan = true, double speedShare = 1, double accelerationLimit = double.PositiveInfinity,
            double jerkLimit = double.PositiveInfinity)
        {
            Predictor = predictor;
            HorizonCap = SettingRange.RequireMs(horizonCapMs, 0, 5000, "horizon cap");
            MaximumGap = SettingRange.RequireMs(maximumGapMs, 1, 60_000, "maximum gap");
            Blend = SettingRange.RequireMs(blendMs, 0, MaxBlendMs, "blend");
            FollowPlan = followPlan;
            SpeedShare = SettingRange.Require(speedShare, MinSpeedShare, 1, "speed share", SettingNames.UrdfVelocityShare);
            AccelerationLimit = RequireLimit(accelerationLimit, "acceleration limit", "rad/s²");
            JerkLimit = RequireLimit(jerkLimit, "jerk limit", "rad/s³");
            Create(JointLimits.None);
        }

        public string Predictor { get; }
        public TimeSpan HorizonCap { get; }
        public TimeSpan MaximumGap { get; }

        /// <summary>Time constant with which a new section replaces the previous section; 0 for an immediate change.</summary>
        public TimeSpan Blend { get; }

        /// <summary>Whether the set-points of /joint_trajectory are used.</summary>
        public bool FollowPlan { get; }

        /// <summary>Fraction of the URDF's velocity limits, above 0, at most 1.</summary>
        public double SpeedShare { get; }

        /// <summary>Acceleration limit of revolute joints in rad/s²; infinity if unknown.</summary>
        public double AccelerationLimit { get; }

        /// <summary>Jerk limit of revolute joints in rad/s³; infinity if unknown.</summary>
        public double JerkLimit { get; }

        /// <summary>Whether the predictor is hold, the reference for comparisons: the newest samples, without blending or plans.</summary>
        internal bool IsHold => Predictor == Predictors.Hold;

        internal bool FollowsPlans => FollowPlan && !IsHold;

        /// <summary>Creates a predictor for one joint with the given limits.</summary>
        /// <param name="limits">Result of <see cref="Bounded"/>.</param>
        public JointPredictor Create(in JointLimits limits) => Create(limits, forecasters: null);

        /// <inheritdoc cref="Create(in JointLimits)"/>
        /// <param name="forecasters"><see cref="Predictors.ForecastersOfJoints"/>, which the predictors of one robot's joints share; null for none.</param>
        internal JointPredictor Create(in JointLimits limits, ForecasterSet forecasters) =>
            Predictors.Create(Predictor, LimitsOf(limits), ClockTicks.Seconds(Blend), forecasters);

        /// <summary>Returns a function that creates a predictor for one object. The objects of a cell share their forecasters.</summary>
        internal Func<BodyPredictor> BodiesOfACell()
        {
            var forecasters = Predictors.ForecastersOfObjects();
            // An object has no limits.
            return () => new BodyPredictor(Predictor, LimitsOf(JointLimits.None), ClockTicks.Seconds(Blend), forecasters);
        }

        /// <summary>Combines a joint's limits with the limits of these settings.</summary>
        /// <param name="isRevolute">Whether acceleration and jerk limits of these settings apply to the joint.</param>
        public JointLimits Bounded(in JointLimits limits, bool isRevolute) => new JointLimits(
            limits.Lower, limits.Upper, limits.Velocity * SpeedShare, limits.Effort,
            isRevolute ? Math.Min(limits.Acceleration, AccelerationLimit) : limits.Acceleration,
            isRevolute ? Math.Min(limits.Jerk, JerkLimit) : limits.Jerk,
            isRevolute && double.IsInfinity(limits.Lower) && double.IsInfinity(limits.Upper));

        PredictionLimits LimitsOf(in JointLimits limits) => new PredictionLimits(
            limits.Lower, limits.Upper, ClockTicks.Seconds(HorizonCap), ClockTicks.Seconds(MaximumGap), limits.Velocity,
            limits.Acceleration, limits.Jerk, limits.IsEndless);

        static double RequireLimit(double value, string name, string unit) =>
            double.IsPositiveInfinity(value) ? value : SettingRange.Require(value, MinLimit, MaxLimit, name, unit);
    }
}
