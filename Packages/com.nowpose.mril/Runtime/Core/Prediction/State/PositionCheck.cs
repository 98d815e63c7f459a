using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.State
{
    /// <summary>Answer to whether the newest position of a motion is right, and the displacement to it a velocity.</summary>
    enum PositionVerdict
    {
        Right,

        /// <summary>
        /// The position may be wrong, which the next samples decide. It is displayed like a motion, but no weight, gate or maximum learns from it.
        /// </summary>
        Unconfirmed,

        /// <summary>
        /// The object is elsewhere at once, or the joint has returned from wrong samples. The position is displayed without extrapolation until the next
        /// sample. Nothing is learned from the forecasts before, and later forecasts do not use earlier samples.
        /// </summary>
        Jumped
    }

    /// <summary>
    /// Decides which positions of a motion are wrong. <see cref="MotionState"/> has the answers, on which all other classes depend.
    /// </summary>
    /// <remarks>
    /// A single wrong sample is known from the next one (<see cref="IsPreviousWrong"/>) and then left out: see
    /// <see cref="MotionState.IsPreviousWrong"/>. For everything else, there is a <see cref="PositionVerdict"/>.
    /// </remarks>
    abstract class PositionCheck
    {
        /// <summary>
        /// Minimum speed to a wrong sample and back, relative to the maximum speed. When a joint reverses at its maximum speed, the ratio is 1. With
        /// 1.3, the errors are the same; with 2, those on recordings are 0.2 % smaller, but wrong samples of fast motions are not found.
        /// </summary>
        const double MinRatioThereAndBack = 1.5;

        /// <summary>Returns whether a motion has gone to the sample before the newest and back at a speed that it has never had.</summary>
        /// <param name="speed">The smaller of the speeds in the last two intervals, per second; their directions are opposite.</param>
        public static bool IsPreviousWrong(MotionState motion, double speed) =>
            motion.Count > 2 && motion.MaxSpeed > 0 && speed > MinRatioThereAndBack * motion.MaxSpeed;

        /// <summary>Examines the newest sample, which is not the first one. A single wrong sample before it is left out.</summary>
        /// <param name="motion">Its verdict is still that of the previous sample.</param>
        /// <param name="hasOtherMotionJumped">
        /// Whether another motion of the same object has jumped at this sample, so that the object is elsewhere.
        /// </param>
        public abstract PositionVerdict Examine(MotionState motion, bool hasOtherMotionJumped);

        /// <summary>Returns the speed of the motion, per second, as far as it is known: the displacement of a jump is not a motion.</summary>
        public virtual double KnownSpeed(MotionState motion) => motion.HasJumped ? 0 : motion.Speed;

        /// <summary>Discards what has been learned from the samples.</summary>
        public virtual void Reset() { }
    }

    /// <summary>
    /// Finds 2 to 20 wrong samples of a joint in a row, from which it then jumps back. The unit and size of a joint are unknown, so only samples that
    /// were further away than any motion so far, and from which the joint returns soon, count as wrong.
    /// </summary>
    sealed class JointPositionCheck : PositionCheck
    {
        /// <summary>
        /// Minimum speed towards a wrong sample, relative to the maximum speed in two consecutive intervals. With 1.5, the errors on recordings are
        /// 0.2 % larger.
        /// </summary>
        const double MinSpeedRatio = 3;

        /// <summary>
        /// Maximum distance of the sample after a wrong one from the last right one, relative to the distance of the wrong one; also that between two
        /// wrong samples. With half or twice this value, the mean errors are the same within 0.05 %.
        /// </summary>
        const double MaxReturnRatio = 0.25;

        /// <summary>
        /// Maximum number of wrong samples in a row: a driver may report zero for a moment. A joint that stays longer was moved, and the weights
        /// learn again. With 10 or 40, the mean errors are the same within 0.05 %.
        /// </summary>
        const int MaxWrong = 20;

        // Position before the first sample that may be wrong, and the number of such samples.
        double _before;
        int _wrong;

        public override PositionVerdict Examine(MotionState motion, bool hasOtherMotionJumped)
        {
            var (newest, previous) = (motion.Newest[0], motion.PositionAt(1, 0));
            if (motion.Verdict == PositionVerdict.Unconfirmed)
            {
                var max = MaxReturnRatio * Math.Abs(previous - _before);
                if (Math.Abs(newest - _before) < max) return PositionVerdict.Jumped;
                if (Math.Abs(newest - previous) < max && _wrong++ < MaxWrong) return PositionVerdict.Unconfirmed;
            }
            (_before, _wrong) = (previous, 1);
            return motion.MaxSpeed > 0 && motion.Speed > MinSpeedRatio * motion.MaxSpeed ? PositionVerdict.Unconfirmed : PositionVerdict.Right;
        }

        /// <inheritdoc/>
        /// <remarks>A joint that has never moved so fast may have jumped. Without the limit, the errors on position jumps are 1.6 % larger.</remarks>
        public override double KnownSpeed(MotionState motion) => Math.Min(base.KnownSpeed(motion), MinSpeedRatio * motion.MaxSpeed);
    }

    /// <summary>
    /// Detects that an object was elsewhere at once: a workpiece that reappears at the start of its conveyor, or an outlier of a tracker.
    /// </summary>
    /// <remarks>
    /// A jump is a change of velocity that needs a larger acceleration than objects have, that is clearly larger than the recent changes, and larger
    /// than the maximum speed of the motion. The second condition distinguishes jumps from a person who shakes an object, the third one from
    /// inaccurate samples of a vehicle. Directly after a jump, the velocity is compared with that before it: an object that moves on as before is at
    /// its new place, and the way back at the end of an outlier is another jump.
    /// </remarks>
    sealed class ObjectPositionCheck : PositionCheck
    {
        /// <summary>
        /// Minimum change of velocity, relative to the mean of the recent changes. With 2.5 or 4, the errors on jumps and on shaken objects are the
        /// same within 4 %.
        /// </summary>
        const double MinChangeRatio = 3;

        /// <summary>Maximum change that enters the mean, relative to the limit of a jump: a far outlier would hide the next ones.</summary>
        const double MaxLearnedRatio = 2;

        /// <summary>
        /// Maximum difference from a jump, relative to its length, of a displacement that continues it: the jump was then a motion.
        /// </summary>
        const double MaxContinuedRatio = 0.5;

        readonly double _minJump, _maxAcceleration;
        readonly double[] _velocity, _newVelocity, _jump, _displacement;
        double _meanChange;
        bool _isKnown;

        /// <param name="minJump">Minimum length of a jump, in m or rad: more than the noise of a tracker.</param>
        /// <param name="maxAcceleration">Maximum acceleration of an object, per second squared.</param>
        public ObjectPositionCheck(int components, double minJump, double maxAcceleration)
        {
            (_minJump, _maxAcceleration) = (minJump, maxAcceleration);
            (_velocity, _newVelocity) = (new double[components], new double[components]);
            (_jump, _displacement) = (new double[components], new double[components]);
        }

        public override PositionVerdict Examine(MotionState motion, bool hasOtherMotionJumped)
        {
            var interval = Math.Max(motion.Timing.Interval, motion.Timing.MeanInterval);
            for (var c = 0; c < _displacement.Length; c++)
            {
                _displacement[c] = -motion.Displacements[_displacement.Length + c];
                // The stamps of two close samples may be inaccurate.
                _newVelocity[c] = _displacement[c] / Math.Max(motion.Interval, motion.Timing.MeanInterval);
            }
            // Minimum change of velocity of a jump that takes place within one interval.
            var limit = Math.Max(_minJump / interval, _maxAcceleration * interval);
            var change = Vectors.Distance(_newVelocity, _velocity);
            var continues = motion.HasJumped && Vectors.Distance(_displacement, _jump) < MaxContinuedRatio * Vectors.Length(_jump);
            // If another part of the pose has jumped, a change is a jump even if an object could make it by moving. An object that moves on has a
            // larger error if it is held than if a smaller change of its velocity is wrong.
            var isJump = _isKnown && !continues && change > motion.MaxSpeed && change > MinChangeRatio * _meanChange
                && (hasOtherMotionJumped || (Vectors.Length(_newVelocity) > limit && change > limit));
            if (_isKnown) _meanChange += (Math.Min(change, MaxLearnedRatio * limit) - _meanChange) * SampleTiming.MeanWeight;
            if (!isJump) _isKnown = true;
            var (from, to) = isJump ? (_displacement, _jump) : (_newVelocity, _velocity);
            Vectors.Copy(from, to);
            return isJump ? PositionVerdict.Jumped : PositionVerdict.Right;
        }

        public override void Reset() => (_meanChange, _isKnown) = (0, false);
    }
}
