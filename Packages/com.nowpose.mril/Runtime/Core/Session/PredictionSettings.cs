using System;
using Nowpose.Kinematics;
using Nowpose.Prediction;

namespace Nowpose.Session
{
    /// <summary>How joints are predicted. Immutable, checked once.</summary>
    public sealed class PredictionSettings
    {
        /// <summary>The paper's choice: quadratic, interpolating.</summary>
        public static readonly PredictionSettings Default = new PredictionSettings();

        /// <param name="predictor">One of <see cref="Predictors.Names"/>.</param>
        /// <param name="horizonCapMs">How far ahead of the newest sample is predicted at most; beyond, the value there stays, marked held.</param>
        /// <param name="maximumGapMs">
        /// A longer pause between two samples ends the history: motion before it says nothing about motion after it.
        /// </param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public PredictionSettings(string predictor = Predictors.Default, double horizonCapMs = 300, double maximumGapMs = 500)
        {
            Predictor = predictor;
            HorizonCap = SettingRange.RequireMs(horizonCapMs, 0, 5000, "horizon cap");
            MaximumGap = SettingRange.RequireMs(maximumGapMs, 1, 60_000, "maximum gap");
            Create(JointLimits.None);
        }

        public string Predictor { get; }
        public TimeSpan HorizonCap { get; }
        public TimeSpan MaximumGap { get; }

        /// <summary>A predictor for one joint, bounded by its limits.</summary>
        public IJointPredictor Create(JointLimits limits) => Predictors.Create(Predictor, new PredictionLimits(
            limits.Lower, limits.Upper, ClockTicks.Seconds(HorizonCap), ClockTicks.Seconds(MaximumGap)));
    }
}
