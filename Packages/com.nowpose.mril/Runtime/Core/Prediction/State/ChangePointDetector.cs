using System;

namespace Nowpose.Prediction.State
{
    /// <summary>Detects change points: samples at which a motion breaks off, so that earlier samples do not predict later ones.</summary>
    /// <remarks>
    /// Samples from before and after an emergency stop together give wrong forecasts. A change point is a change of velocity with a larger acceleration
    /// than all recent changes, whose maximum is forgotten with the time constant of the weights. There are two exceptions. At a start, samples from
    /// before it do no harm: if the speed has increased and the next sample confirms it, all samples are used again. After a velocity that is constant to
    /// rounding, each large change is a change point, even if earlier ones were faster: without noise, a conveyor or turntable that is switched on moves
    /// at full speed at once.
    /// </remarks>
    sealed class ChangePointDetector
    {
        /// <summary>
        /// Minimum ratio of the acceleration at a change point to the maximum recent acceleration. With 1.2, the errors of simulated motions are
        /// 2.9 % larger; with 2, those of recordings 1.4 %.
        /// </summary>
        const double MinAccelerationRatio = 1.5;

        /// <summary>
        /// Minimum change of velocity, relative to the maximum recent speed. Without this condition, the errors are 1.5 % (recordings) and 0.5 %
        /// (simulated) larger.
        /// </summary>
        const double MinChangeRatio = 0.25;

        /// <summary>
        /// The same after a constant velocity or a rest without noise, if the acceleration need not exceed earlier ones. A stop within an interval
        /// shows in two intervals; one of the two changes exceeds half of the speed. With 0.25, smooth moves of simulated motions have 0.3 % larger
        /// errors.
        /// </summary>
        const double MinSteadyChangeRatio = 0.5;

        /// <summary>
        /// Maximum change of a constant velocity, relative to the motion's maximum speed. Without the rule, turntables with abrupt starts had up to 1.3
        /// times the error of the line. With 1e-3, the errors on such motions are the same, but workpieces of a UR5, whose smooth moves are almost
        /// uniform at times, have up to 3.5 % larger errors.
        /// </summary>
        const double SteadyRatio = 1e-6;

        // Acceleration and speed of the newest samples, which raise the maxima when a later sample shows that they were right.
        double _acceleration, _speed;
        double _maxAcceleration, _maxSpeed;

        // SamplesSince before the newest sample, which is valid again if this sample was wrong.
        int _formerSince;
        bool _wasSteady;

        /// <summary>
        /// Number of samples since the newest change point, including the sample at which it was detected; int.MaxValue if there is none since the
        /// last gap or jump, or if it was an increase of the speed that has been confirmed.
        /// </summary>
        public int SamplesSince { get; private set; } = int.MaxValue;

        /// <summary>Whether the newest change point increased the speed.</summary>
        public bool SpeedIncreased { get; private set; }

        /// <summary>Whether the velocity in the last two intervals is constant to rounding; true for a rest without noise.</summary>
        public bool IsSteady { get; private set; }

        /// <summary>Adds the newest sample of a motion.</summary>
        /// <param name="forgettingFactor">Factor of the maxima since the previous sample, 0 to 1.</param>
        public void Add(MotionState motion, double forgettingFactor)
        {
            if (motion.IsPreviousWrong) SamplesSince = _formerSince;
            _formerSince = SamplesSince;
            if (motion.IsPreviousWrong || motion.HasJumped) (_acceleration, _speed) = (0, 0);
            UpdateMaxima(motion.IsUnconfirmed, forgettingFactor);
            // The displacement over a gap or a jump is not a velocity.
            if (motion.Connected < 2) (SamplesSince, IsSteady, _wasSteady) = (int.MaxValue, false, false);
            else Compare(motion);
        }

        public void Reset()
        {
            _acceleration = _speed = _maxAcceleration = _maxSpeed = 0;
            SamplesSince = _formerSince = int.MaxValue;
            SpeedIncreased = IsSteady = _wasSteady = false;
        }

        void UpdateMaxima(bool isUnconfirmed, double forgettingFactor)
        {
            if (!isUnconfirmed)
            {
                (_maxAcceleration, _maxSpeed) = (Math.Max(_maxAcceleration, _acceleration), Math.Max(_maxSpeed, _speed));
                (_acceleration, _speed) = (0, 0);
            }
            (_maxAcceleration, _maxSpeed) = (_maxAcceleration * forgettingFactor, _maxSpeed * forgettingFactor);
        }

        void Compare(MotionState motion)
        {
            SamplesSince = Math.Min(SamplesSince, int.MaxValue - 1) + 1;
            double newest = motion.Speed, before = Vectors.Length(motion.VelocityBefore);
            var change = Vectors.Distance(motion.Velocity, motion.VelocityBefore);
            // An abrupt change within an interval shows in the velocity of two intervals.
            var isSteady = IsSteady || _wasSteady;
            (_wasSteady, IsSteady) = (IsSteady, change <= SteadyRatio * motion.MaxSpeed);
            _speed = Math.Max(_speed, newest);
            if (motion.Connected < 3) return;
            var acceleration = change / (0.5 * (motion.Interval + motion.Times[1] - motion.Times[2]));
            var product = Vectors.Dot(motion.Velocity, motion.VelocityBefore);
            if (!isSteady && IsConfirmed(newest, before, product)) SamplesSince = int.MaxValue;
            else if (IsChangePoint(change, acceleration, isSteady))
            {
                SamplesSince = 1;
                // A slow motion in the opposite direction is noise before a start, not a reversal.
                SpeedIncreased = newest > before && (product >= 0 || before < MinChangeRatio * newest);
            }
            _acceleration = Math.Max(_acceleration, acceleration);
        }

        // A joint that starts does not become slower. Without the confirmation, the errors on recordings are 1.0 % larger.
        bool IsConfirmed(double newest, double before, double product) => SamplesSince == 2 && SpeedIncreased && product > 0 && newest >= before;

        bool IsChangePoint(double change, double acceleration, bool isSteady) =>
            change >= (isSteady ? MinSteadyChangeRatio : MinChangeRatio) * _maxSpeed && (isSteady || acceleration > MinAccelerationRatio * _maxAcceleration);
    }
}
