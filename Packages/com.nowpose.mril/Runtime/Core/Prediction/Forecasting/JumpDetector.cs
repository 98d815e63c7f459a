using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Detects that an object was elsewhere at once, so that the displacement in the newest interval is not a velocity: a workpiece that reappears at the
    /// start of its conveyor, or an outlier of a tracker.
    /// </summary>
    /// <remarks>
    /// A jump of an object is a change of velocity that needs a larger acceleration than objects have, and that is clearly larger than the recent
    /// changes. The latter
    /// distinguishes jumps from a person who shakes an object. Directly after a jump, the velocity is compared with that before it: an object that moves on
    /// as before is at its new place, and the way back at the end of an outlier is another jump.
    /// The unit and size of a joint are unknown, so its only jump is the way back from a sample that was further away than any motion so far: that sample was
    /// wrong. Allocates nothing after construction.
    /// </remarks>
    sealed class JumpDetector
    {
        /// <summary>
        /// Minimum change of velocity, relative to the mean of the recent changes. With 2.5 or 4, the errors on jumps and on shaken objects are the same
        /// within 4 %.
        /// </summary>
        const double MinChangeRatio = 3;

        /// <summary>Weight of a new change in the mean.</summary>
        const double Smoothing = 1 / 8.0;

        /// <summary>Maximum change that enters the mean, relative to the limit of a jump: a far outlier would hide the next ones.</summary>
        const double MaxLearnedRatio = 2;

        /// <summary>Maximum difference from a jump, relative to its length, of a displacement that continues it: the jump was then a motion.</summary>
        const double MaxContinuedRatio = 0.5;

        /// <summary>Minimum speed towards a wrong sample of a joint, relative to the maximum speed in two consecutive intervals.</summary>
        const double MinSpeedRatio = 3;

        /// <summary>Maximum distance of the sample after a wrong one from the sample before it, relative to the distance of the wrong one.</summary>
        const double MaxReturnRatio = 0.25;

        readonly double _minJump, _maxAcceleration;
        readonly double[] _velocity, _newVelocity, _jump, _displacement;
        double _meanChange, _before;
        bool _isKnown;

        /// <summary>Creates a detector for a joint.</summary>
        public JumpDetector() : this(1, double.NaN, double.NaN) { }

        /// <summary>Creates a detector for the position or the angles of an object.</summary>
        /// <param name="components">Number of components of a position.</param>
        /// <param name="minJump">Minimum length of a jump, in m or rad: more than the noise of a tracker.</param>
        /// <param name="maxAcceleration">Maximum acceleration of an object, per second squared.</param>
        public JumpDetector(int components, double minJump, double maxAcceleration)
        {
            (_minJump, _maxAcceleration) = (minJump, maxAcceleration);
            (_velocity, _newVelocity) = (new double[components], new double[components]);
            (_jump, _displacement) = (new double[components], new double[components]);
        }

        /// <summary>Number of samples since the newest jump, including the sample at the new place.</summary>
        public int SamplesSince { get; private set; } = int.MaxValue;

        /// <summary>Whether the newest sample is a jump.</summary>
        public bool HasJumped => SamplesSince == 1;

        /// <summary>Whether the newest sample of a joint may be wrong, which the next sample decides.</summary>
        public bool IsUnconfirmed { get; private set; }

        /// <summary>Adds the newest sample of a motion. The first displacement is not a jump, because the velocity before it is unknown.</summary>
        public void Add(MotionState motion)
        {
            if (motion.Timing.ConnectedSamples < 2)
            {
                Reset();
                return;
            }
            // The stamps of two close samples may be inaccurate.
            var interval = Math.Max(motion.NewestTime - motion.PreviousTime, motion.Timing.MeanInterval);
            for (var c = 0; c < _displacement.Length; c++)
            {
                _displacement[c] = motion.Newest[c] - motion.Previous[c];
                _newVelocity[c] = _displacement[c] / interval;
            }
            var isJump = double.IsNaN(_minJump) ? IsReturn(motion) : IsJump(motion, interval);
            SamplesSince = isJump ? 1 : Math.Min(SamplesSince, int.MaxValue - 1) + 1;
            if (!isJump) _isKnown = true;
            var (from, to) = isJump ? (_displacement, _jump) : (_newVelocity, _velocity);
            Array.Copy(from, to, to.Length);
        }

        /// <summary>Counts the newest jump as a motion, because a repetition explains it.</summary>
        public void Dismiss() => (SamplesSince, _isKnown) = (int.MaxValue, false);

        public void Reset() => (SamplesSince, _meanChange, _isKnown, IsUnconfirmed) = (int.MaxValue, 0, false, false);

        bool IsReturn(MotionState motion)
        {
            var isReturn = IsUnconfirmed && Math.Abs(motion.Newest[0] - _before) < MaxReturnRatio * Math.Abs(motion.Previous[0] - _before);
            IsUnconfirmed = !isReturn && motion.MaxSpeed > 0 && motion.Speed > MinSpeedRatio * motion.MaxSpeed;
            _before = motion.Previous[0];
            return isReturn;
        }

        // If another part of the pose has jumped, a change is a jump even if an object could make it by moving.
        bool IsJump(MotionState motion, double interval)
        {
            if (!_isKnown) return false;
            var (change, speed) = (Vectors.Distance(_newVelocity, _velocity), Vectors.Length(_newVelocity));
            var limit = Math.Max(_minJump / interval, _maxAcceleration * interval);
            var isJump = change > MinChangeRatio * _meanChange && (motion.IsElsewhere || (speed > limit && change > limit));
            _meanChange += (Math.Min(change, MaxLearnedRatio * limit) - _meanChange) * Smoothing;
            var continues = HasJumped && Vectors.Distance(_displacement, _jump) < MaxContinuedRatio * Vectors.Length(_jump);
            return isJump && !continues;
        }
    }
}
