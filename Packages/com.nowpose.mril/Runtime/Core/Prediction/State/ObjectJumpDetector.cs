using System;

namespace Nowpose.Prediction.State
{
    /// <summary>
    /// Detects that an object was elsewhere at once: a workpiece that reappears at the start of its conveyor, or an outlier of a tracker.
    /// </summary>
    /// <remarks>
    /// A jump is a change of velocity that needs a larger acceleration than objects have, and that is clearly larger than the recent changes. The latter
    /// distinguishes jumps from a person who shakes an object. Directly after a jump, the velocity is compared with that before it: an object that moves on
    /// as before is at its new place, and the way back at the end of an outlier is another jump.
    /// </remarks>
    sealed class ObjectJumpDetector : JumpDetector
    {
        /// <summary>
        /// Minimum change of velocity, relative to the mean of the recent changes. With 2.5 or 4, the errors on jumps and on shaken objects are the same
        /// within 4 %.
        /// </summary>
        const double MinChangeRatio = 3;

        /// <summary>Weight of a new change in the mean. With half or twice this value, the errors of objects change by at most 0.1 %.</summary>
        const double Smoothing = 1 / 8.0;

        /// <summary>Maximum change that enters the mean, relative to the limit of a jump: a far outlier would hide the next ones.</summary>
        const double MaxLearnedRatio = 2;

        /// <summary>Maximum difference from a jump, relative to its length, of a displacement that continues it: the jump was then a motion.</summary>
        const double MaxContinuedRatio = 0.5;

        readonly double _minJump, _maxAcceleration;
        readonly double[] _velocity, _newVelocity, _jump, _displacement;
        double _meanChange;
        bool _isKnown;

        /// <param name="components">Number of components of a position.</param>
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

        protected override bool IsDiscontinuity(MotionState motion)
        {
            // The stamps of two close samples may be inaccurate.
            var interval = Math.Max(motion.Timing.Interval, motion.Timing.MeanInterval);
            for (var c = 0; c < _displacement.Length; c++)
            {
                _displacement[c] = motion.Newest[c] - motion.Previous[c];
                _newVelocity[c] = _displacement[c] / interval;
            }
            var continues = IsVelocityUnknown && Vectors.Distance(_displacement, _jump) < MaxContinuedRatio * Vectors.Length(_jump);
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
    }
}
