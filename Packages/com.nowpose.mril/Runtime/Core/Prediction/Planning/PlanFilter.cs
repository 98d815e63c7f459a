using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>Estimates the delay and the offset with which a joint follows its plan. Detects whether the joint follows its plan.</summary>
    /// <remarks>
    /// Position of the joint = plan(t − delay) + offset. A Kalman filter estimates both values together, because each sample shows only
    /// their combined effect. The delay has an effect only while the plan moves. Its initial standard deviation is 0.1 s; the first moves reduce it.
    /// </remarks>
    sealed class PlanFilter
    {
        /// <summary>
        /// Standard deviation of an unknown delay, s. With <see cref="MaxStandardErrors"/>, delays of up to about 0.5 s are accepted at first.
        /// </summary>
        const double UnknownDelay = 0.1;

        /// <summary>
        /// Standard deviation of an unknown offset, relative to the plan's range. With <see cref="MaxStandardErrors"/>, offsets of up to a tenth of
        /// the range are accepted at first; a larger one means that the plan belongs to another motion.
        /// </summary>
        const double UnknownOffset = 0.02;

        /// <summary>
        /// Standard deviation of the residual while the plan is followed: a share of the plan's range, for the drive's dynamics, plus the sensor's
        /// noise, in rad or m.
        /// </summary>
        const double NoiseRatio = 0.005, MinNoise = 1e-4;

        /// <summary>
        /// Standard deviation of the change within one second: of the delay, in s, and of the offset, relative to the standard deviation of an
        /// unknown offset. They keep the gains of the filter above zero, so that it follows slow changes.
        /// </summary>
        const double DelayDrift = 0.005, OffsetDrift = 0.2;

        /// <summary>
        /// Maximum residual, in standard deviations, of a joint that follows the plan: one in 1.7 million normally distributed residuals is larger.
        /// </summary>
        const double MaxStandardErrors = 5;

        double _varDelay, _covariance, _varOffset;
        double _time;
        bool _hasStarted;

        /// <summary>Delay in s; positive if the joint lags behind the plan.</summary>
        public double Delay { get; private set; }

        /// <summary>Offset in rad or m.</summary>
        public double Offset { get; private set; }

        /// <summary>Starts a plan. Keeps the estimated delay and offset, and increases the uncertainty of the offset if necessary.</summary>
        public void Start(double range)
        {
            if (!_hasStarted) _varDelay = UnknownDelay * UnknownDelay;
            _varOffset = Math.Max(_varOffset, InitialVariance(range));
            _hasStarted = true;
        }

        /// <summary>Compares the plan with a sample, and updates the estimates if the joint follows.</summary>
        /// <param name="time">Time of the sample, s.</param>
        /// <param name="difference">Sample minus plan(t − <see cref="Delay"/>) − <see cref="Offset"/>, in rad or m.</param>
        /// <param name="velocity">Velocity of the plan at this time, per second.</param>
        /// <param name="range">Range of the plan's positions, in rad or m.</param>
        /// <returns>Verdict of the sample on whether the joint follows the plan.</returns>
        public PlanVerdict Add(double time, double difference, double velocity, double range)
        {
            // At most one second counts: a pause does not make the estimate worthless, and at first, the time of the last sample is unknown.
            AddProcessNoise(Math.Min(Math.Max(time - _time, 0), 1), range);
            _time = time;
            var noise = NoiseRatio * range + MinNoise;
            // The difference is −velocity · delay error + offset error.
            var delayGain = -velocity * _varDelay + _covariance;
            var offsetGain = -velocity * _covariance + _varOffset;
            var variance = -velocity * delayGain + offsetGain + noise * noise;
            // Also rejects NaN: values such as 1e200 must not enter the filter.
            if (!(difference * difference <= MaxStandardErrors * MaxStandardErrors * variance) || !(variance < JointSample.MaxMagnitude * JointSample.MaxMagnitude)) return PlanVerdict.NotFollowed;
            (delayGain, offsetGain) = (delayGain / variance, offsetGain / variance);
            Delay += delayGain * difference;
            Offset += offsetGain * difference;
            var (delayOld, both, offsetOld) = (_varDelay, _covariance, _varOffset);
            // Rounding must not make a variance negative.
            _varDelay = Math.Max((1 + delayGain * velocity) * delayOld - delayGain * both, 0);
            _covariance = (1 + delayGain * velocity) * both - delayGain * offsetOld;
            _varOffset = Math.Max(offsetGain * velocity * both + (1 - offsetGain) * offsetOld, 0);
            // A plan that hardly moves agrees with any joint that is at rest at the planned position.
            return Math.Abs(velocity) * UnknownDelay > MaxStandardErrors * noise ? PlanVerdict.Followed : PlanVerdict.Unclear;
        }

        public void Reset()
        {
            Delay = Offset = _varDelay = _covariance = _varOffset = _time = 0;
            _hasStarted = false;
        }

        // Not above the initial variances: otherwise a plan that is not followed for minutes would accept any joint.
        void AddProcessNoise(double seconds, double range)
        {
            var initial = InitialVariance(range);
            _varDelay = Grown(_varDelay, DelayDrift * DelayDrift * seconds, UnknownDelay * UnknownDelay);
            _varOffset = Grown(_varOffset, OffsetDrift * OffsetDrift * initial * seconds, initial);
        }

        static double Grown(double variance, double growth, double max) => Math.Max(variance, Math.Min(variance + growth, max));

        static double InitialVariance(double range)
        {
            var offset = UnknownOffset * Math.Min(range, JointSample.MaxMagnitude) + MinNoise;
            return offset * offset;
        }
    }

    /// <summary>Verdict of one sample on whether a joint follows its plan.</summary>
    enum PlanVerdict
    {
        /// <summary>The difference exceeds the plan's uncertainty.</summary>
        NotFollowed,

        /// <summary>The plan hardly moves, so the sample is not conclusive.</summary>
        Unclear,

        Followed
    }
}
