namespace Nowpose.Prediction.State
{
    /// <summary>
    /// Detects that the displacement in the newest interval is not a velocity, because the joint or object is elsewhere at once.
    /// </summary>
    abstract class JumpDetector
    {
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
            if (motion.Count < 2) Reset();
            else SamplesSince = IsDiscontinuity(motion) ? 1 : SampleCount.Next(SamplesSince);
        }

        public virtual void Reset() => (SamplesSince, IsUnconfirmed) = (int.MaxValue, false);

        /// <summary>Returns whether the displacement to the newest sample is not a velocity.</summary>
        protected abstract bool IsDiscontinuity(MotionState motion);
    }
}
