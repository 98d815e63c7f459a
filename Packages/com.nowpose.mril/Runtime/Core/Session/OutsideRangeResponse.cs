namespace Nowpose.Session
{
    /// <summary>
    /// Display of the robot while the render time is outside the constant-latency range, where frames appear later than calibrated.
    /// In all cases the state is <see cref="PoseState.OutsideRange"/>, and text and stripes distinguish the pose from a current one.
    /// </summary>
    public enum OutsideRangeResponse
    {
        /// <summary>The robot is fainter; its pose is computed as usual.</summary>
        Fade,

        /// <summary>The robot has its usual brightness; its pose is computed as usual.</summary>
        GoOn,

        /// <summary>The robot is as faint as a held pose and shows the newest samples without compensation.</summary>
        Hold,
    }
}
