using System;

namespace Nowpose.Prediction.Stacking
{
    /// <summary>Notices when a motion breaks off: then the samples before say nothing about those after.</summary>
    /// <remarks>
    /// An emergency stop poisons every window that straddles it. A shock is a change of velocity faster than any of the last
    /// seconds; when the one after it confirms that the machine has started rather than stopped, all samples count again.
    /// </remarks>
    sealed class ShockDetector
    {
        /// <summary>How much greater an acceleration must be than any remembered one.</summary>
        const double Surprise = 1.5;

        const double AccelerationMemory = 8;
        const double SpeedMemory = 20;

        /// <summary>A change of velocity counts only if it is this share of the greatest speed remembered.</summary>
        const double LeastShareOfSpeed = 0.25;

        /// <summary>A started motion keeps at least so much of its speed.</summary>
        const double Confirmation = 0.9;

        const int AllSamples = 99;

        double _greatestAcceleration;
        double _greatestSpeed;

        /// <summary>How many of the newest samples belong to one motion.</summary>
        public int Available { get; private set; }

        /// <summary>Whether the newest shock was one that sped the motion up.</summary>
        public bool HasGrown { get; private set; }

        /// <summary>Shocks since the start.</summary>
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
                else if (acceleration > Surprise * _greatestAcceleration && acceleration > 0 && change >= LeastShareOfSpeed * _greatestSpeed)
                {
                    Available = 1;
                    HasGrown = Math.Abs(speed) > Math.Abs(speedBefore) && speed * speedBefore >= 0;
                    Count++;
                }
                _greatestAcceleration = Math.Max(_greatestAcceleration * Math.Exp(-interval / AccelerationMemory), acceleration);
            }
            if (samples >= 2) _greatestSpeed = Math.Max(_greatestSpeed * Math.Exp(-interval / SpeedMemory), Math.Abs(speed));
        }

        public void Reset()
        {
            _greatestAcceleration = _greatestSpeed = 0;
            Available = Count = 0;
            HasGrown = false;
        }
    }
}
