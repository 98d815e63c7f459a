using System;

namespace Nowpose.Prediction.State
{
    /// <summary>
    /// Detects the way back from wrong samples of a joint. The unit and size of a joint are unknown, so only samples that were further away than any
    /// motion so far, and from which the joint returns soon, count as wrong.
    /// </summary>
    sealed class OutlierReturnDetector : JumpDetector
    {
        /// <summary>
        /// Minimum speed towards a wrong sample, relative to the maximum speed in two consecutive intervals. With 1.5, the errors on recordings are 0.2 %
        /// larger.
        /// </summary>
        const double MinSpeedRatio = 3;

        /// <summary>
        /// Maximum distance of the sample after a wrong one from the last right one, relative to the distance of the wrong one; also that between two
        /// wrong samples. With half or twice this value, the mean errors are the same within 0.05 %.
        /// </summary>
        const double MaxReturnRatio = 0.25;

        /// <summary>
        /// Maximum number of wrong samples in a row: a driver may report zero for a moment. A joint that stays longer was moved, and the weights learn
        /// again. With 10 or 40, the mean errors are the same within 0.05 %.
        /// </summary>
        const int MaxWrong = 20;

        // Position before the first sample that may be wrong, and the number of such samples.
        double _before;
        int _wrong;

        protected override bool IsDiscontinuity(MotionState motion)
        {
            var max = MaxReturnRatio * Math.Abs(motion.Previous[0] - _before);
            var isReturn = IsUnconfirmed && Math.Abs(motion.Newest[0] - _before) < max;
            var stays = IsUnconfirmed && _wrong < MaxWrong && Math.Abs(motion.Newest[0] - motion.Previous[0]) < max;
            if (stays) _wrong++;
            else
            {
                IsUnconfirmed = !isReturn && motion.MaxSpeed > 0 && motion.Speed > MinSpeedRatio * motion.MaxSpeed;
                (_before, _wrong) = (motion.Previous[0], 1);
            }
            return isReturn;
        }
    }
}
