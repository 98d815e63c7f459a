namespace Nowpose.Session
{
    /// <summary>
    /// State of the displayed pose relative to the robot's current pose. A pose in any state except <see cref="Current"/> must look different from a
    /// current pose.
    /// </summary>
    /// <remarks>The states are ordered by severity, the most severe first, and are compared in this order.</remarks>
    public enum PoseState
    {
        /// <summary>
        /// A joint between base and tool has not received a sample yet and is shown at zero, or the parent of a moving base is unknown.
        /// </summary>
        Incomplete,

        /// <summary>
        /// The display time is not accurate enough: the clock is unsynchronised (the newest samples are shown unchanged), still
        /// converging, or in holdover for so long that its error exceeds the setting.
        /// </summary>
        Unsynchronised,

        /// <summary>
        /// A joint between base and tool is held: its samples are older than the horizon cap, later than the display time, or too few for
        /// a prediction. The state is also used if the gateway reports that a joint of the robot has no data, which the gateway may detect
        /// before the samples are too old, and if the pose of a moving base is not current.
        /// </summary>
        Held,

        /// <summary>
        /// The render time is outside the constant-latency range, or frames miss refreshes, so that frames appear later than calibrated, by an
        /// unknown amount. The pose is computed like a current pose, unless the settings require a held pose, see <see cref="OutsideRangeResponse"/>.
        /// </summary>
        OutsideRange,

        /// <summary>
        /// All joints between base and tool are predicted to, or interpolated at, the display time. After a step of the control clock, this
        /// state remains until two sync exchanges indicate the step.
        /// </summary>
        Current,
    }

    /// <summary>Names of pose states in diagnostics and on the command line.</summary>
    static class PoseStateName
    {
        public static string Of(SessionStatistics statistics) => Of(statistics.Pose, statistics.IsClockCoarse);

        /// <param name="isClockCoarse">Whether the clock that determined the display time is coarse according to the session's settings.</param>
        public static string Of(PoseState pose, bool isClockCoarse)
        {
            switch (pose)
            {
                case PoseState.Current: return isClockCoarse ? "coarse" : "current";
                case PoseState.OutsideRange: return "outside";
                case PoseState.Held: return "held";
                case PoseState.Unsynchronised: return "unsynchronised";
                default: return "incomplete";
            }
        }
    }
}
