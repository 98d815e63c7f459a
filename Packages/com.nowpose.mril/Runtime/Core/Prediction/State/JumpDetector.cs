using System;

namespace Nowpose.Prediction.State
{
    /// <summary>Detects that the displacement in the newest interval is not a velocity, because the joint or object is elsewhere at once.</summary>
    /// <remarks>
    /// <para>An object jumps if a workpiece reappears at the start of its conveyor, or if a tracker confuses two poses: its velocity then changes by more than
    /// an object can accelerate, and clearly more than recently, which a person who shakes an object does not exceed. Directly after a jump, the velocity is
    /// compared with that before it: an object that moves on as before is at its new place, and the way back at the end of an outlier is another jump.</para>
    /// <para>The unit and size of a joint are unknown, so a first move cannot be distinguished from a jump. Only samples that are further away than any motion
    /// so far, and from which the joint returns soon, count as wrong; their way back is the jump.</para>
    /// </remarks>
    sealed class JumpDetector
    {
        /// <summary>
        /// Minimum change of an object's velocity, relative to the mean of the recent changes. With 2.5 or 4, the errors on jumps and on shaken objects are the
        /// same within 4 %.
        /// </summary>
        const double MinChangeRatio = 3;

        /// <summary>Weight of a new change in the mean. With half or twice this value, the errors of objects change by at most 0.1 %.</summary>
        const double Smoothing = 1 / 8.0;

        /// <summary>Maximum change that enters the mean, relative to the limit of a jump: a far outlier would hide the next ones.</summary>
        const double MaxLearnedRatio = 2;

        /// <summary>
        /// Maximum difference, relative to the length of a jump, of a place or displacement that counts as the same: of a displacement that continues the jump,
        /// which was then a motion, of a joint that has returned, and of two wrong samples.
        /// </summary>
        const double MaxDifferenceRatio = 0.5;

        /// <summary>
        /// Minimum speed towards a wrong sample of a joint, relative to the maximum speed in two consecutive intervals. With 1.5, the errors on recordings are
        /// 0.2 % larger.
        /// </summary>
        const double MinSpeedRatio = 3;

        /// <summary>
        /// Maximum number of wrong samples in a row: a driver may report zero for a moment. A joint that stays longer was moved, and the weights learn
        /// again. With 10 or 40, the mean errors are the same within 0.05 %.
        /// </summary>
        const int MaxWrong = 20;

        readonly double _minJump, _maxAcceleration;
        readonly double[] _displacement, _newVelocity;

        // Of an object: velocity before the newest jump, and the jump. Of a joint: position before the first sample that may be wrong.
        readonly double[] _velocity, _jump, _before;
        double _meanChange;
        bool _isKnown;

        // Number of samples of a joint that may be wrong.
        int _wrong;

        JumpDetector(int components, double minJump, double maxAcceleration)
        {
            (_minJump, _maxAcceleration) = (minJump, maxAcceleration);
            (_displacement, _newVelocity, _velocity) = (new double[components], new double[components], new double[components]);
            (_jump, _before) = (new double[components], new double[components]);
        }

        /// <summary>Creates the detector of a joint, whose unit and size are unknown.</summary>
        public static JumpDetector OfJoint() => new JumpDetector(1, double.NaN, double.NaN);

        /// <summary>Creates the detector of the position or the rotation of an object.</summary>
        /// <param name="components">Number of components of a position.</param>
        /// <param name="minJump">Minimum length of a jump, in m or rad: more than the noise of a tracker.</param>
        /// <param name="maxAcceleration">Maximum acceleration of an object, per second squared.</param>
        public static JumpDetector OfObject(int components, double minJump, double maxAcceleration) => new JumpDetector(components, minJump, maxAcceleration);

        /// <summary>Number of samples since the newest jump, including the sample after it.</summary>
        public int SamplesSince { get; private set; } = int.MaxValue;

        /// <summary>
        /// Whether the displacement in the newest interval is not a velocity: the way of an object to another place, or of a joint back from a wrong sample.
        /// </summary>
        public bool IsVelocityUnknown => SamplesSince == 1;

        /// <summary>Whether the newest sample of a joint may be wrong, which the next samples decide.</summary>
        public bool IsUnconfirmed { get; private set; }

        /// <summary>Adds the newest sample of a motion. The first displacement is not a jump, because the velocity before it is unknown.</summary>
        public void Add(MotionState motion)
        {
            if (motion.Count < 2) Reset();
            else SamplesSince = (double.IsNaN(_minJump) ? HasReturned(motion) : HasJumped(motion)) ? 1 : Math.Min(SamplesSince, int.MaxValue - 1) + 1;
        }

        public void Reset() => (SamplesSince, IsUnconfirmed, _meanChange, _isKnown) = (int.MaxValue, false, 0, false);

        bool HasJumped(MotionState motion)
        {
            // The stamps of two close samples may be inaccurate.
            var interval = Math.Max(motion.Timing.Interval, motion.Timing.MeanInterval);
            for (var c = 0; c < _displacement.Length; c++)
            {
                _displacement[c] = motion.Newest[c] - motion.Previous[c];
                _newVelocity[c] = _displacement[c] / interval;
            }
            var continues = IsVelocityUnknown && Vectors.Distance(_displacement, _jump) < MaxDifferenceRatio * Vectors.Length(_jump);
            var isJump = _isKnown && IsAbrupt(interval, motion.HasOtherMotionJumped) && !continues;
            if (!isJump) _isKnown = true;
            var (from, to) = isJump ? (_displacement, _jump) : (_newVelocity, _velocity);
            Array.Copy(from, to, to.Length);
            return isJump;
        }

        // If another part of the pose has jumped, a change is a jump even if an object could make it by moving.
        bool IsAbrupt(double interval, bool hasOtherMotionJumped)
        {
            var (change, speed) = (Vectors.Distance(_newVelocity, _velocity), Vectors.Length(_newVelocity));
            var limit = Math.Max(_minJump / interval, _maxAcceleration * interval);
            var isAbrupt = change > MinChangeRatio * _meanChange && (hasOtherMotionJumped || (speed > limit && change > limit));
            _meanChange += (Math.Min(change, MaxLearnedRatio * limit) - _meanChange) * Smoothing;
            return isAbrupt;
        }

        bool HasReturned(MotionState motion)
        {
            var max = MaxDifferenceRatio * Vectors.Distance(motion.Previous, _before);
            var isReturn = IsUnconfirmed && Vectors.Distance(motion.Newest, _before) < max;
            var stays = IsUnconfirmed && _wrong < MaxWrong && Vectors.Distance(motion.Newest, motion.Previous) < max;
            if (stays) _wrong++;
            else
            {
                IsUnconfirmed = !isReturn && motion.MaxSpeed > 0 && motion.Speed > MinSpeedRatio * motion.MaxSpeed;
                Array.Copy(motion.Previous, _before, _before.Length);
                _wrong = 1;
            }
            return isReturn;
        }
    }
}
