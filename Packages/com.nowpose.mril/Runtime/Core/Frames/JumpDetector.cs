using System;

namespace Nowpose.Frames
{
    /// <summary>
    /// Detects that a vector was elsewhere at once, so that the displacement in the newest interval is not a velocity: a workpiece that reappears at the
    /// start of its conveyor, or an outlier of a tracker.
    /// </summary>
    /// <remarks>
    /// A jump is a change of velocity that needs a larger acceleration than objects have, and that is clearly larger than the recent changes. The latter
    /// distinguishes jumps from a person who shakes an object. Directly after a jump, the velocity is compared with that before it: an object that moves on
    /// as before is at its new place, and the way back at the end of an outlier is another jump. Allocates nothing.
    /// </remarks>
    sealed class JumpDetector
    {
        /// <summary>
        /// Minimum length of a jump in m, which is more than the noise of a tracker, and maximum acceleration of an object in m/s². With 10 m/s², the
        /// errors of vehicles that start at once are 5 % larger.
        /// </summary>
        const double MinJump = 0.03, MaxAcceleration = 40;

        /// <summary>The same for the rotation, in rad and rad/s².</summary>
        const double MinTurn = 0.1, MaxAngularAcceleration = 100;

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

        readonly double _minJump, _maxAcceleration;
        Vector3D _velocity, _jump;
        double _meanChange;
        bool _isKnown;

        public JumpDetector(BodyPart part) =>
            (_minJump, _maxAcceleration) = part == BodyPart.Position ? (MinJump, MaxAcceleration) : (MinTurn, MaxAngularAcceleration);

        /// <summary>Number of samples since the newest jump, including the sample at the new place.</summary>
        public int SamplesSince { get; private set; } = int.MaxValue;

        /// <summary>Whether the newest sample is a jump.</summary>
        public bool HasJumped => SamplesSince == 1;

        /// <summary>Adds a sample. The first displacement is not a jump, because the velocity before it is unknown.</summary>
        /// <param name="displacement">Displacement in the interval before the sample.</param>
        /// <param name="interval">Length of the interval, in s.</param>
        /// <param name="isElsewhere">
        /// Whether the other part of the pose has jumped. A change is then a jump even if an object could make it by moving.
        /// </param>
        public void Add(in Vector3D displacement, double interval, bool isElsewhere)
        {
            var velocity = displacement * (1 / interval);
            var continues = HasJumped && (displacement - _jump).Length < MaxContinuedRatio * _jump.Length;
            var isJump = _isKnown && IsJump(velocity, interval, isElsewhere) && !continues;
            SamplesSince = isJump ? 1 : Math.Min(SamplesSince, int.MaxValue - 1) + 1;
            if (isJump) _jump = displacement;
            else (_velocity, _isKnown) = (velocity, true);
        }

        /// <summary>Counts the newest jump as a motion, because a repetition explains it.</summary>
        public void Dismiss() => (SamplesSince, _isKnown) = (int.MaxValue, false);

        /// <summary>Forgets the velocity after a gap between the samples.</summary>
        public void Clear() => (SamplesSince, _meanChange, _isKnown) = (int.MaxValue, 0, false);

        bool IsJump(in Vector3D velocity, double interval, bool isElsewhere)
        {
            var change = (velocity - _velocity).Length;
            var limit = Math.Max(_minJump / interval, _maxAcceleration * interval);
            var isJump = change > MinChangeRatio * _meanChange && (isElsewhere || (velocity.Length > limit && change > limit));
            _meanChange += (Math.Min(change, MaxLearnedRatio * limit) - _meanChange) * Smoothing;
            return isJump;
        }
    }
}
