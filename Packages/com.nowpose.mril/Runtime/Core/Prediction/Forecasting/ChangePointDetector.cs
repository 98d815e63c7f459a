using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Detects change points: samples at which a motion breaks off, so that earlier samples do not predict later ones.</summary>
    /// <remarks>
    /// A window of samples across an emergency stop gives wrong forecasts. A change point is a change of velocity that is faster than all other
    /// changes in the last few seconds. If it increased the speed, and the next sample confirms the new speed, all samples are used again: the
    /// samples of a joint at rest do not impair the forecast of its start.
    /// </remarks>
    sealed class ChangePointDetector
    {
        /// <summary>
        /// Minimum ratio of the acceleration at a change point to the maximum recent acceleration. With 1.2, the errors of simulated motions are
        /// 2.9 % larger; with 2, those of recordings 1.4 %.
        /// </summary>
        const double MinAccelerationRatio = 1.5;

        /// <summary>
        /// Forgetting time constant of the maximum acceleration and the maximum speed, in s: several moves of most machines. It is independent
        /// of the forgetting factor of the weights; with 10 or 40 s, the errors change by at most 0.5 %.
        /// </summary>
        const double TimeConstant = 20;

        /// <summary>
        /// Minimum change of velocity, relative to the maximum recent speed. Without this condition, the errors are 1.5 % (recordings) and 0.5 %
        /// (simulated) larger.
        /// </summary>
        const double MinChangeRatio = 0.25;

        /// <summary>
        /// Minimum speed at the sample that confirms an increase of the speed, relative to the speed at the change point. A joint that starts does
        /// not become slower; the difference from 1 allows for noise. Without the confirmation, the errors on recordings are 1.0 % larger.
        /// </summary>
        const double MinConfirmationRatio = 0.9;

        double _maxAcceleration;
        double _maxSpeed;

        /// <summary>
        /// Number of samples since the newest change point, including the sample at which it was detected; the number of all samples after an
        /// increase of the speed has been confirmed.
        /// </summary>
        public int SamplesSince { get; private set; }

        /// <summary>Whether the newest change point increased the speed.</summary>
        public bool SpeedIncreased { get; private set; }

        /// <summary>Number of change points since the start.</summary>
        public int Count { get; private set; }

        /// <summary>Adds a sample. The speeds in the last two intervals are in the samples' unit per second; the intervals are in s.</summary>
        /// <param name="samples">Number of samples, including the newest.</param>
        /// <param name="speed">Displacement ÷ interval before the newest sample; 0 if there is none.</param>
        /// <param name="speedBefore">Speed in the previous interval.</param>
        public void Add(int samples, double interval, double speed, double intervalBefore, double speedBefore)
        {
            SamplesSince++;
            if (samples < 2) return;
            var forgettingFactor = Math.Exp(-interval / TimeConstant);
            if (samples >= 3)
            {
                var change = Math.Abs(speed - speedBefore);
                var acceleration = change / (0.5 * (interval + intervalBefore));
                var isSameDirection = speed * speedBefore > 0;
                if (SamplesSince == 2 && SpeedIncreased && isSameDirection && Math.Abs(speed) >= MinConfirmationRatio * Math.Abs(speedBefore))
                    SamplesSince = samples;
                else if (acceleration > MinAccelerationRatio * _maxAcceleration && change >= MinChangeRatio * _maxSpeed)
                {
                    SamplesSince = 1;
                    SpeedIncreased = Math.Abs(speed) > Math.Abs(speedBefore) && speed * speedBefore >= 0;
                    Count++;
                }
                _maxAcceleration = Math.Max(_maxAcceleration * forgettingFactor, acceleration);
            }
            _maxSpeed = Math.Max(_maxSpeed * forgettingFactor, Math.Abs(speed));
        }

        public void Reset()
        {
            _maxAcceleration = _maxSpeed = 0;
            SamplesSince = Count = 0;
            SpeedIncreased = false;
        }
    }
}
