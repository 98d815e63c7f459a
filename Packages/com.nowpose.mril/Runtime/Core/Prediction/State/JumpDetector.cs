using System;

namespace Nowpose.Prediction.State
{
    /// <summary>
    /// Detects that the displacement in the newest interval is not a velocity, because the joint or object is elsewhere at once. Allocates nothing after
    /// construction.
    /// </summary>
    abstract class JumpDetector
    {
        /// <summary>Number of samples since the newest jump, including the sample at the new place.</summary>
        public int SamplesSince { get; private set; } = int.MaxValue;

        /// <summary>
        /// Whether the newest sample is a jump: for an object, the first sample at the new place; for a joint, the sample after a wrong one.
        /// </summary>
        public bool HasJumped => SamplesSince == 1;

        /// <summary>Whether the newest sample may be wrong, which the next sample decides.</summary>
        public virtual bool IsUnconfirmed => false;

        /// <summary>Adds the newest sample of a motion. The first displacement is not a jump, because the velocity before it is unknown.</summary>
        public void Add(MotionState motion)
        {
            if (motion.Timing.ConnectedSamples < 2) Reset();
            else SamplesSince = IsJump(motion) ? 1 : Math.Min(SamplesSince, int.MaxValue - 1) + 1;
        }

        /// <summary>Counts the newest jump as a motion, because a repetition explains it.</summary>
        public virtual void Dismiss() => SamplesSince = int.MaxValue;

        public virtual void Reset() => SamplesSince = int.MaxValue;

        /// <summary>Returns whether the newest sample, which has a predecessor, is a jump.</summary>
        protected abstract bool IsJump(MotionState motion);
    }
}
