using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>Names of pose states in diagnostics and on the command line.</summary>
    static class PoseStateName
    {
        /// <param name="clock">Clock that determined the display time of the pose.</param>
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
