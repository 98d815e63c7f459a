namespace Nowpose.Session
{
    /// <summary>
    /// What is shown while the render time is outside the constant-latency range, where light appears later than calibrated.
    /// Whichever it is, <see cref="PoseState.OutsideRange"/> is said, and words and stripes tell the pose from a current one.
    /// </summary>
    public enum OutsideRangeResponse
    {
        /// <summary>Fainter as well: the pose goes on as a current one is made.</summary>
        Fade,

        /// <summary>As bright as ever: the pose goes on.</summary>
        GoOn,

        /// <summary>As faint as a held pose: the newest samples as they are, as if nothing were compensated.</summary>
        Hold,
    }
}
