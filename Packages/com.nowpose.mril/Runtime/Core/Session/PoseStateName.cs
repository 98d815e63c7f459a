namespace Nowpose.Session
{
    /// <summary>Names of pose states in diagnostics and on the command line.</summary>
    static class PoseStateName
    {
        public static string Of(SessionStatistics statistics) => Of(statistics.Pose, statistics.IsClockCoarse);

        /// <param name="isClockCoarse">Whether the clock that determined the display time of the pose is coarse by the session's settings.</param>
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
