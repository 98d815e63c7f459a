using Nowpose.Session;

namespace Nowpose.Unity.Messages
{
    /// <summary>Values and reasons that the status panel shows.</summary>
    static class StatusMessages
    {
        public const string LatenciesDiffer = "runtime and calibration differ";
        public const string LatencyPredicted = "predicted by the runtime";
        public const string RenderingTooLong = "rendering takes too long";
        public const string TooFewSamples = "too few recent samples";
        public const string JointWithoutSamples = "a joint has no samples";
        public const string BaseNotCurrent = "its base is not current";
        public const string RobotNotAdded = "not added to the session; the log states the reason";
        public const string NoLimit = "no limit is known";
        public const string OtherSourceLimit = "limit is for another source";

        public static string FurtherParts(int count) => "! and " + count + " more";

        /// <summary>Returns the reason why a robot's pose is not current; empty if it is current.</summary>
        /// <param name="isLimitedByBase">Whether the robot's moving base is the reason.</param>
        public static string ReasonOf(PoseState pose, bool isLimitedByBase = false)
        {
            if (isLimitedByBase) return BaseNotCurrent;
            switch (pose)
            {
                case PoseState.Current: return "";
                case PoseState.OutsideRange: return RenderingTooLong;
                case PoseState.Held: return TooFewSamples;
                case PoseState.Unsynchronised: return "time not known";
                default: return JointWithoutSamples;
            }
        }
    }
}
