using System;
using Nowpose.Protocol;

namespace Nowpose.Messages
{
    /// <summary>Error messages about frames, grips and the file of stationary frames.</summary>
    static class FrameMessages
    {
        public static string NotFinite(double time, double x, double y, double z, double order) =>
            FormattableString.Invariant($"time, position and order must be finite; they are {time} s, ({x}, {y}, {z}) m, {order} s");

        public const string NoPose = "no pose received";
        public const string PosesStopped = "no new poses are arriving";
        public const string PosesTooRare = "its poses arrive too rarely to be predicted";
        public const string PosesTooOld = "its poses arrive too late to be displayed; check the network and the clock of its source";
        public const string OlderThanConnection = "no pose since the connection was restored; check its source";

        /// <param name="parent">The parent that the frame's source reports.</param>
        public static string ParentRefused(string parent) =>
            $"its source reports the parent {Above(parent)}, which is the frame itself, a frame on it, or too deep in the tree; correct header.frame_id";

        /// <param name="frame">A frame above the object.</param>
        public static string FrameUnknown(string frame) => $"frame {Above(frame)}, on which it depends, is unknown";

        /// <param name="frame">A frame above the object.</param>
        public static string FrameNotCurrent(string frame) => $"frame {Above(frame)}, on which it depends, is not current";

        /// <param name="first">One of the objects.</param>
        public static string NotCurrent(string first, int count) =>
            count == 1 ? $"object {first} is not current" : FormattableString.Invariant($"{count} objects are not current, for example {first}");

        static string Above(string frame) => InputException.OneLine(frame, ProtocolLimits.NameLength);

        /// <param name="fault">Reason why it is unknown what a gripper holds.</param>
        public static string MayBeGripped(string fault) => $"a gripper may have moved it: {fault}";

        public const string RotationLength = "the rotation has length 0; a unit quaternion is needed";
        public const string ClosedAtUnknownTime = "the gripper closed at an unknown time, so the held object is unknown; open and close the gripper";

        public const string SignalRestarted =
            "the gripper's signal restarted while the gripper was closed, so the held object is unknown; open and close the gripper";

        public const string SignalInterrupted =
            "the gripper's signal was interrupted and may have changed, so the held object is unknown; open and close the gripper";

        public const string ObjectWithoutPose =
            "the pose of an object was unknown when the gripper closed, so the held object is unknown; open and close the gripper";

        public const string OpenedWithoutData =
            "the arm had no data when the gripper opened, so the place of the released object is unknown; move or grip the object";

        public const string ArmWithoutData = "the arm had no data when the gripper closed, so the held object is unknown; open and close the gripper";
        public const string ReleasedUnnoticed = "a gripper may have released it at another place; move or grip the object";

        public const string CarrierMoved =
            "the parent that the object's source reports has moved since the gripper released the object; report the object's new pose or parent";

        public const string List = "list of stationary frames";

        public static string NotUnitQuaternion(string tolerance) => $"a rotation is not a unit quaternion; its norm must be 1 ± {tolerance}; normalise it";

        public const string FileNumber = "a number is not finite; correct it";
        public const string OwnParent = "a frame is its own parent; correct its header.frame_id";
        public const string NoTransforms = "the list transforms is missing or empty; add at least one frame";
        public const string FileEmpty = "the file is empty; write a tf2_msgs/TFMessage in JSON";

        public const string ChildTwice = "a child_frame_id occurs twice; remove one";

        /// <param name="problem">Predicate of a sentence whose subject is the frame.</param>
        public static string OfFrame(string frame, string problem) => $"frame {frame} {problem}";

        /// <param name="number">Place in the list, for a frame without a name.</param>
        public static string OfTransform(int number, string problem) => $"transform {number} {problem}";

        public const string IsOwnParent = "is its own parent; correct its header.frame_id";
        public const string OccursTwice = "occurs twice as child_frame_id; remove one";

        public static string NoField(string field) => $"has no {field}; add it";
        public static string WrongField(string field, string value, string allowed) => $"has {field} {value}; enter {allowed}";

        public const string FiniteNumber = "a finite number";
        public const string Text = "a text";
        public const string Object = "a JSON object";

        public static string Coordinate(double max) => FormattableString.Invariant($"a number from -{max} to {max} m");

        public static string Norm(double norm, string tolerance) =>
            FormattableString.Invariant($"has a transform.rotation with the norm {norm:0.#######}; it must be 1 ± {tolerance}; normalise it");

        public static string TooManyFrames(int max) => $"more than {max} frames; remove some";

        public static string FileLine(string path, int line, string fault) => $"{path}, line {line}: {fault}";

        public static string LongName(string field, int length, int max) =>
            FormattableString.Invariant($"has {field} with {length} characters; allowed: {max}; an emoji counts as two characters");

        public static string NotTransforms(DropReason fault) => $"the file is not a tf2_msgs/TFMessage in JSON ({fault}); correct the file";
    }
}
