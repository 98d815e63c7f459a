using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Finds change points, where a motion breaks off: then the samples before say nothing about those after.</summary>
    /// <remarks>
    /// An emergency stop poisons every window that straddles it. A change point is a change of velocity faster than any of the last
    /// seconds; when the one after it confirms that the machine has started rather than stopped, all samples count again.
    /// </remarks>
    sealed class ChangePointDetector
    {
        /// <summary>Ratio of an acceleration at a change point to the maximum remembered one.</summary>
        const double Surprise = 1.5;

        /// <summary>In which the greatest acceleration, and the greatest speed, fade to 1/e, s: several moves of most machines.</summary>
        const double AccelerationMemory = 8, SpeedMemory = 20;

        /// <summary>A change of velocity counts only if it is this share of the greatest speed remembered.</summary>
        const double MinShareOfSpeed = 0.25;

        /// <summary>Minimum share of its speed that a started motion keeps.</summary>
        const double Confirmation = 0.9;

        /// <summary>More than any forecaster looks at.</summary>
        const int AllSamples = 99;

        double _maxAcceleration;
        double _maxSpeed;

        /// <summary>Number of newest samples that belong to one motion.</summary>
        public int Available { get; private set; }

        /// <summary>Whether the newest change point was one that sped the motion up.</summary>
        public bool HasGrown { get; private set; }

        /// <summary>Change points since the start.</summary>
        public int Count { get; private set; }

        /// <summary>Takes in the intervals before the newest sample, in samples' units and s.</summary>
        /// <param name="samples">Samples there are, the newest included.</param>
        /// <param name="speed">Increment ÷ interval before the newest sample; 0 without one.</param>
        /// <param name="speedBefore">The one before.</param>
        public void Add(int samples, double interval, double speed, double intervalBefore, double speedBefore)
        {
            Available++;
            if (samples >= 3)
            {
                var change = Math.Abs(speed - speedBefore);
                var acceleration = change / (0.5 * (interval + intervalBefore));
                var isSameDirection = speed * speedBefore > 0;
                if (Available == 2 && HasGrown && isSameDirection && Math.Abs(speed) >= Confirmation * Math.Abs(speedBefore))
                    Available = AllSamples;
                else if (acceleration > Surprise * _maxAcceleration && acceleration > 0 && change >= MinShareOfSpeed * _maxSpeed)
                {
                    Available = 1;
                    HasGrown = Math.Abs(speed) > Math.Abs(speedBefore) && speed * speedBefore >= 0;
                    Count++;
                }
                _maxAcceleration = Math.Max(_maxAcceleration * Math.Exp(-interval / AccelerationMemory), acceleration);
            }
            if (samples >= 2) _maxSpeed = Math.Max(_maxSpeed * Math.Exp(-interval / SpeedMemory), Math.Abs(speed));
        }

        public void Reset()
        {
            _maxAcceleration = _maxSpeed = 0;
            Available = Count = 0;
            HasGrown = false;
        }
    }
}
