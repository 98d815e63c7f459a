using System;

namespace Nowpose.Prediction.State
{
    /// <summary>
    /// Detects the way back from a wrong sample of a joint. The unit and size of a joint are unknown, so only a sample that was further away than any
    /// motion so far, and from which the next sample returns, counts as wrong.
    /// </summary>
    sealed class OutlierReturnDetector : JumpDetector
    {
        /// <summary>
        /// Minimum speed towards a wrong sample, relative to the maximum speed in two consecutive intervals. With 1.5, the errors on recordings are 0.2 %
        /// larger.
        /// </summary>
        const double MinSpeedRatio = 3;

        /// <summary>Maximum distance of the sample after a wrong one from the sample before it, relative to the distance of the wrong one.</summary>
        const double MaxReturnRatio = 0.25;

        // Position before the newest sample but one.
        double _before;

        protected override bool IsJump(MotionState motion)
        {
            var isReturn = IsUnconfirmed && Math.Abs(motion.Newest[0] - _before) < MaxReturnRatio * Math.Abs(motion.Previous[0] - _before);
            IsUnconfirmed = !isReturn && motion.MaxSpeed > 0 && motion.Speed > MinSpeedRatio * motion.MaxSpeed;
            _before = motion.Previous[0];
            return isReturn;
        }
    }
}
