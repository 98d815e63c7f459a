using System;
using System.Collections.Generic;
using System.Globalization;

namespace Nowpose.Messages
{
    /// <summary>Error messages about robots and their joint values.</summary>
    static class RobotMessages
    {
        public static string PoseCount(int poses, int links) => $"{poses} poses were passed for {links} links; pass one pose for each link";

        public static string BeyondLimits(string joint, double position, string unit, double lower, double upper, string otherUnit) =>
            FormattableString.Invariant($"joint '{joint}': {Short(position)} {unit} is outside its limits {Short(lower)} to {Short(upper)} ")
            + FormattableString.Invariant($"{unit}, and is drawn at the limit; check that the robot description belongs to this robot and ")
            + FormattableString.Invariant($"contains its limits, and that the source sends {unit}, not {otherUnit}");

        /// <summary>Returns a position for a message. A large one has an exponent, because it would otherwise have up to 309 digits.</summary>
        public static string Short(double position) =>
            position.ToString(Math.Abs(position) < 1e6 ? "0.###" : "0.###E+0", CultureInfo.InvariantCulture);

        public const string DescriptionDiffers =
            "its description differs from that of the gateway, so the pose may be wrong; use the gateway's description on this headset";

        public const string StampsAhead =
            "the time stamps of the joint positions are ahead of the control clock, so the robot is shown too late or not at all; set the clock of their "
            + "source";

        /// <summary>Reason of a joint.</summary>
        public const string SamplesTooOld = "its samples arrive too late to be displayed; check the network and the clock of its source";

        public static string OfRobot(string robot, string fault) => $"robot {robot}: {fault}";

        public static string ValueCount(int values, int joints) =>
            $"{values} values were passed for {joints} moving joints; pass one value for each moving joint";

        public static string NoMovingJoint(string robot) => $"robot {robot}: has no moving joint; choose another robot";

        public static string WaypointOutOfLimits(
            string robot, int waypoint, string joint, double position, string unit, double lower, double upper) =>
            FormattableString.Invariant($"robot {robot}: at waypoint {waypoint}, joint {joint} is at {position} {unit}; allowed: {lower} to ")
            + FormattableString.Invariant($"{upper} {unit}; choose another robot");

        public static string TooManyJoints(string robot, int joints, int max) =>
            $"robot {robot}: has {joints} moving joints; a message contains at most {max}; make some of them fixed";

        public static string NamespaceTaken(string name, string robot) =>
            $"robot namespace '{name}': robot {robot} already has it; give each robot its own namespace";

        public static string TooManyRobots(string name, int max) =>
            $"robot namespace '{name}': the cell already has {max} robots in namespaces, which is the maximum; remove one of them";

        public static string NamespaceInvalid(string name, int max) =>
            $"robot namespace: is '{name}'; allowed: a letter, then letters, digits and underscores, up to {max} characters";

        /// <param name="name">Namespace of the robot; empty for the robot without a namespace.</param>
        /// <param name="served">Namespaces of the robots that the gateway serves.</param>
        public static string OtherNamespaces(string name, IReadOnlyList<string> served) =>
            (name.Length == 0 ? "the gateway serves no robot without a namespace" : $"the gateway serves no robot in the namespace {name}")
            + $"; it serves {string.Join(", ", served)}; use one of these names as the robot's namespace";
    }
}
