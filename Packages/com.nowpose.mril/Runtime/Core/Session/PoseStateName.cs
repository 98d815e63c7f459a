using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>Names of pose states as diagnostics and command line write them.</summary>
    static class PoseStateName
    {
        /// <param name="clock">The clock that the pose's display time comes from.</param>
        public static string Of(PoseState pose, in ClockModel clock)
        {
            switch (pose)
            {
                case PoseState.Current: return ClockSettings.Default.IsCoarse(clock) ? "coarse" : "current";
                case PoseState.OutsideRange: return "outside";
                case PoseState.Held: return "held";
                case PoseState.Unsynchronised: return "unsynchronised";
                default: return "incomplete";
            }
        }
    }
}
