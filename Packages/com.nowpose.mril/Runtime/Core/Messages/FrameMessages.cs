using System;

namespace Nowpose.Messages
{
    /// <summary>Error messages about frames, grips and the file of stationary frames.</summary>
    static class FrameMessages
    {
        public static string NotFinite(double time, double x, double y, double z, double order) =>
            FormattableString.Invariant($"time, position and order must be finite; they are {time} s, ({x}, {y}, {z}) m, {order} s");

        public const string RotationLength = "the rotation has length 0; a unit quaternion is needed";
        public const string ClosedAtUnknownTime = "the gripper closed at an unknown time, so the held object is unknown; open and close the gripper";

        public const string SignalRestarted =
            "the gripper's signal restarted while the gripper was closed, so the held object is unknown; open and close the gripper";

        public const string ArmWithoutData = "the arm had no data when the gripper closed, so the held object is unknown; open and close the gripper";
        public const string List = "list of stationary frames";

        public static string NotUnitQuaternion(string tolerance) => $"a rotation is not a unit quaternion; its norm must be 1 ± {tolerance}; normalise it";

        public const string FileNumber = "a number is not finite; correct it";
        public const string OwnParent = "a frame is its own parent; correct its header.frame_id";
        public const string FieldMissing = "a field is missing; add it";

        public const string ChildTwice = "a child_frame_id occurs twice; remove one";

        public static string TooManyFrames(int max) => $"more than {max} frames; remove some";

        public static string FileLine(string path, int line, string fault) => $"{path}, line {line}: {fault}";

        public static string NotTransforms(DropReason fault) => $"is not a tf2_msgs/TFMessage in JSON ({fault}); correct the file";
    }
}
