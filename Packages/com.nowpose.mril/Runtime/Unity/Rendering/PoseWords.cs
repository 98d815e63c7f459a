using Nowpose.Session;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Names of the states of a pose. The text beside the robot and the status panel use the same names.</summary>
    static class PoseWords
    {
        public static string Of(PoseState pose, OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade)
        {
            if (pose == PoseState.OutsideRange && outsideRange == OutsideRangeResponse.Hold) return "held: outside range";
            switch (pose)
            {
                case PoseState.Current: return "current";
                case PoseState.OutsideRange: return "outside range";
                case PoseState.Held: return "held";
                case PoseState.Unsynchronised: return "not synchronised";
                default: return "no positions yet";
            }
        }
    }
}
