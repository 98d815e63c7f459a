namespace Nowpose.Session
{
    /// <summary>Names of pose states as diagnostics and command line write them.</summary>
    static class PoseStateName
    {
        /// <param name="clock">State of the clock that the pose's display time comes from.</param>
        public static string Of(PoseState pose, ClockState clock)
        {
            switch (pose)
            {
                case PoseState.Current: return CurrentBy(clock);
                case PoseState.OutsideRange: return "outside";
                case PoseState.Held: return "held";
                case PoseState.Unsynchronised: return "unsynchronised";
                default: return "incomplete";
            }
        }

        // The one place that decides between "current" and "coarse": a current pose whose clock is known only coarsely.
        static string CurrentBy(ClockState clock) => clock == ClockState.Coarse ? "coarse" : "current";
    }
}
