using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.State
{
    /// <summary>
    /// Detects that the displacement in the newest interval is not a velocity, because the joint or object is elsewhere at once.
    /// </summary>
    abstract class JumpDetector
    {
        int _sinceBefore = int.MaxValue;

        /// <summary>Number of samples since the newest jump, including the sample after it.</summary>
        public int SamplesSince { get; private set; } = int.MaxValue;

        /// <summary>
        /// Whether the displacement in the newest interval is not a velocity: the way of an object to another place, or of a joint back from a wrong sample.
        /// </summary>
        public bool IsVelocityUnknown => SamplesSince == 1;

        /// <summary>Whether the newest sample may be wrong, which the next samples decide.</summary>
        public bool IsUnconfirmed { get; protected set; }

        /// <summary>Adds the newest sample of a motion. The first displacement is not a jump, because the velocity before it is unknown.</summary>
        public void Add(MotionState motion)
        {
            if (motion.Count < 2)
            {
                Reset();
                return;
            }
            // The displacement to a wrong sample does not count as a jump.
            if (!motion.IsPreviousWrong) _sinceBefore = SamplesSince;
            SamplesSince = Detect(motion) ? 1 : Math.Min(_sinceBefore, int.MaxValue - 1) + 1;
        }

        public virtual void Reset() => (SamplesSince, _sinceBefore, IsUnconfirmed) = (int.MaxValue, int.MaxValue, false);

        /// <summary>Examines the newest sample.</summary>
        /// <returns>Whether the displacement to it is not a velocity.</returns>
        protected abstract bool Detect(MotionState motion);
    }

    /// <summary>
    /// Detects the way back from 2 to 20 wrong samples of a joint; <see cref="MotionState"/> leaves a single one out. The unit and size of a joint are
    /// unknown, so only samples that were further away than any motion so far, and from which the joint returns soon, count as wrong.
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

        protected override bool Detect(MotionState motion)
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

    /// <summary>
    /// Detects that an object was elsewhere at once: a workpiece that reappears at the start of its conveyor, or an outlier of a tracker.
    /// </summary>
    /// <remarks>
    /// A jump is a change of velocity that needs a larger acceleration than objects have, that is clearly larger than the recent changes, and larger than the
    /// maximum speed of the motion. The second condition distinguishes jumps from a person who shakes an object, the third one from inaccurate samples of a
    /// vehicle. Directly after a jump, the velocity is compared with that before it: an object that moves on as before is at its new place, and the way back
    /// at the end of an outlier is another jump.
    /// </remarks>
    sealed class ObjectJumpDetector : JumpDetector
    {
        /// <summary>
        /// Minimum change of velocity, relative to the mean of the recent changes. With 2.5 or 4, the errors on jumps and on shaken objects are the same
        /// within 4 %.
        /// </summary>
        const double MinChangeRatio = 3;

        /// <summary>Maximum change that enters the mean, relative to the limit of a jump: a far outlier would hide the next ones.</summary>
        const double MaxLearnedRatio = 2;

        /// <summary>Maximum difference from a jump, relative to its length, of a displacement that continues it: the jump was then a motion.</summary>
        const double MaxContinuedRatio = 0.5;

        readonly double _minJump, _maxAcceleration;
        readonly double[] _velocity, _newVelocity, _jump, _displacement;
        double _meanChange;
        bool _isKnown;

        /// <param name="minJump">Minimum length of a jump, in m or rad: more than the noise of a tracker.</param>
        /// <param name="maxAcceleration">Maximum acceleration of an object, per second squared.</param>
        public ObjectJumpDetector(int components, double minJump, double maxAcceleration)
        {
            (_minJump, _maxAcceleration) = (minJump, maxAcceleration);
            (_velocity, _newVelocity) = (new double[components], new double[components]);
            (_jump, _displacement) = (new double[components], new double[components]);
        }

        public override void Reset()
        {
            base.Reset();
            (_meanChange, _isKnown) = (0, false);
        }

        protected override bool Detect(MotionState motion)
        {
            for (var c = 0; c < _displacement.Length; c++)
            {
                _displacement[c] = motion.Newest[c] - motion.Previous[c];
                // The stamps of two close samples may be inaccurate.
                _newVelocity[c] = _displacement[c] / Math.Max(motion.Interval, motion.Timing.MeanInterval);
            }
            var continues = IsVelocityUnknown && Vectors.Distance(_displacement, _jump) < MaxContinuedRatio * Vectors.Length(_jump);
            var (change, limit) = (Vectors.Distance(_newVelocity, _velocity), LimitOf(motion));
            var isJump = _isKnown && IsAbrupt(motion, change, limit) && !continues;
            if (_isKnown) _meanChange += (Math.Min(change, MaxLearnedRatio * limit) - _meanChange) * SampleTiming.MeanWeight;
            if (!isJump) _isKnown = true;
            var (from, to) = isJump ? (_displacement, _jump) : (_newVelocity, _velocity);
            Vectors.Copy(from, to);
            return isJump;
        }

        // If another part of the pose has jumped, a change is a jump even if an object could make it by moving. An object that moves on has a larger error if it
        // is held than if a smaller change of its velocity is wrong.
        bool IsAbrupt(MotionState motion, double change, double limit) => change > motion.MaxSpeed && change > MinChangeRatio * _meanChange
            && (motion.HasOtherMotionJumped || (Vectors.Length(_newVelocity) > limit && change > limit));

        // Minimum change of velocity of a jump that takes place within one interval.
        double LimitOf(MotionState motion)
        {
            var interval = Math.Max(motion.Timing.Interval, motion.Timing.MeanInterval);
            return Math.Max(_minJump / interval, _maxAcceleration * interval);
        }
    }
}
