using Nowpose.Session;

namespace Nowpose.Unity.Messages
{
    /// <summary>Names of the states of a pose, and reasons why a pose is not current.</summary>
    static class PoseMessages
    {
        public const string GripperNotMoved = "gripper not moved";
        public const string GripperUnattached = "the gripper is disabled or is not attached to a link of an active rig";
        public const string RigNotMoved = "rig not moved";
        public const string RigDisabled = "the rig is disabled or cannot show the robot";
        public const string Shifted = "shifted";
        public const string ShiftedByEye = "it is shifted for a calibration by eye; apply the marks, or set the shift to 0";
        public const string SessionPaused = "the session is disabled or paused";
        public const string Uncompensated = "uncompensated";
        public const string NotPlaced = "it was placed neither by hand nor by a source";

        /// <summary>Returns the label of parts that show the newest samples.</summary>
        /// <param name="label">Label of their state; empty if it is current.</param>
        public static string OfGhost(string label) => label.Length > 0 ? Uncompensated + ", " + label : Uncompensated;

        /// <summary>Returns the name of a state. The text beside the robot and the status panel use the same name.</summary>
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
