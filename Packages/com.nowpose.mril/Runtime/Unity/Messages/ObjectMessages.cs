using System;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Unity.Messages
{
    /// <summary>Error messages about objects of the cell, and names of their states.</summary>
    static class ObjectMessages
    {
        public const string OtherMover = "the tracked or stationary object on the same object moves it; put the actuated part on a child object";

        public const string DisabledByItself =
            "one of its events has disabled it, or has switched off its object or a parent, so it raises no more events; select another "
            + "object in the event, such as a child";

        public const string MovedTwice = "moved by another component";
        public const string SignalNotCurrent = "signal not current";
        public const string OutsideStroke = "value outside the stroke";
        public const string FingerNotMoved = "finger not moved";
        public const string FromGripper = "a gripper";
        public const string PlacedByHand = "placed by hand";
        public const string RobotUnknown = "its robot is unknown";

        public static string Disabled(string kind, string component) => $"{kind} '{component}' is disabled; enable it and its object, or remove it";

        public static string MovedByJoint(string rig, string joint) =>
            $"joint '{joint}' of the rig '{rig}' moves the same object; put the actuated part on a child object";

        public static string MovedByGripper(string gripper, string joint) =>
            $"gripper '{gripper}' moves the same object with joint '{joint}'; put the actuated part on a child object, or remove the finger from the "
            + "gripper";

        /// <param name="frame">An invalid name.</param>
        public static string InvalidFrame(string frame) =>
            $"the frame '{InputException.OneLine(frame, 32)}' is not a valid name; allowed: 1 to {ProtocolLimits.NameLength} characters, not "
            + $"'{FrameParents.World}'; correct Frame";

        public static string NoLink(string robot, string link) => $"the robot '{robot}' has no link '{link}'; correct Link";

        public static string NotPlaceable(string component) =>
            $"stationary object '{component}': its source or a gripper moves it, so it cannot be placed by hand; "
            + "stop its source, or release it from the gripper";

        public static string SameFrame(string component, string frame) =>
            $"stationary object '{component}': another object has the same frame '{frame}', so each replaces the saved place of the other; "
            + "enter another Frame";

        public static string NotAccepted(string title, DropReason reason) =>
            $"{title} cannot be placed: {reason}; correct its frame, or reduce the frames of the cell";

        public static string ValueOutsideStroke(double value) =>
            $"the value {RobotMessages.Short(value)} is outside the stroke; publish a value from 0 to 1";

        public const string NotPlaced = "not placed; place it by hand, or publish its frame on /tf_static";

        public static string PlaceNotSaved(string name, string file) =>
            $"stationary object '{name}': its place is not saved, because {file} cannot be read; close the other program and place the object again";

        /// <param name="copy">Path of the saved copy of the invalid file; null if it could not be saved.</param>
        public static string PlacesLost(string reason, string copy) => copy == null
            ? $"{reason}; place the objects again"
            : $"{reason}; the file is kept as {copy}; place the objects again";
    }
}
