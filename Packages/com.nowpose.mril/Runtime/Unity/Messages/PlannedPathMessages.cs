namespace Nowpose.Unity.Messages
{
    /// <summary>Reasons why the planned path of a tool is not drawn.</summary>
    static class PlannedPathMessages
    {
        public const string NoPlan = "no set-points of all joints up to the tool have arrived, or the robot does not follow them";
        public const string BaseMoves = "the robot stands on an object that can move, and set-points do not contain the motion of this object";
        public const string CarrierUnknown = "the rig above the robot's rig shows no robot of the same session";
        public const string CarrierNotCurrent = "the pose of the robot that carries this robot is not current, or its rig shows the newest samples";
        public const string CarrierWithoutPlan = "the robot that carries this robot has no set-points, or does not follow them";
    }
}
