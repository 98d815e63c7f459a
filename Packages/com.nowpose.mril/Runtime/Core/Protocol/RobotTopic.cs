using System;
using Nowpose.Messages;

namespace Nowpose.Protocol
{
    /// <summary>
    /// A topic name, split into the namespace of a robot and the robot's topic: <c>/arm1/joint_states</c> is <see cref="RosTopics.JointStates"/>
    /// of the robot <c>arm1</c>.
    /// </summary>
    sealed class RobotTopic
    {
        /// <summary>Topics that each robot has.</summary>
        public static readonly string[] OfRobots = { RosTopics.JointStates, RosTopics.JointTrajectory, RosTopics.RobotDescription };

        RobotTopic(string robot, string kind, bool isValid)
        {
            Robot = robot;
            Kind = kind;
            IsValid = isValid;
        }

        /// <summary>Namespace of the robot without slashes; empty for a topic without a namespace.</summary>
        public string Robot { get; }

        /// <summary>The topic name without the namespace of a robot.</summary>
        public string Kind { get; }

        /// <summary>False if the name ends with a robot's topic, but the part before it is not a valid namespace.</summary>
        public bool IsValid { get; }

        public static RobotTopic Parse(string name)
        {
            foreach (var kind in OfRobots)
            {
                if (name.Length <= kind.Length || name[0] != '/' || !name.EndsWith(kind, StringComparison.Ordinal)) continue;
                var robot = name.Substring(1, name.Length - kind.Length - 1);
                return IsNamespace(robot) ? new RobotTopic(robot, kind, true) : new RobotTopic("", name, false);
            }

            return new RobotTopic("", name, true);
        }

        /// <summary>Returns the full name of a robot's topic.</summary>
        /// <param name="robot">The robot's namespace; empty for the robot without a namespace.</param>
        /// <param name="kind">/joint_states, /joint_trajectory or /robot_description.</param>
        public static string NameOf(string robot, string kind) => robot.Length == 0 ? kind : "/" + robot + kind;

        /// <summary>Returns a joint or link name that is unique in the cell, such as <c>arm1/tool0</c>.</summary>
        /// <param name="robot">The robot's namespace; empty for the robot without a namespace.</param>
        public static string Qualified(string robot, string name) => robot.Length == 0 ? name : robot + "/" + name;

        /// <summary>Returns the joint of another robot that has the same cell-wide name; its name is null if there is none.</summary>
        /// <param name="robot">The robot's namespace; empty for the robot without a namespace.</param>
        public static (string Robot, string Name) OtherOf(string robot, string name)
        {
            if (robot.Length > 0) return ("", Qualified(robot, name));
            var slash = name.IndexOf('/');
            return slash > 0 && slash < name.Length - 1 && IsNamespace(name.AsSpan(0, slash))
                ? (name.Substring(0, slash), name.Substring(slash + 1)) : (null, null);
        }

        /// <summary>Returns whether a name is not longer than the protocol allows. The namespace of a robot before it is not counted.</summary>
        public static bool HasNameLength(string name)
        {
            if (name.Length <= ProtocolLimits.NameLength) return true;
            var slash = name.IndexOf('/');
            return slash > 0 && name.Length - slash - 1 <= ProtocolLimits.NameLength && IsNamespace(name.AsSpan(0, slash));
        }

        /// <summary>
        /// Returns whether a string is a valid namespace of a robot: a letter, then letters, digits and underscores, at most 32 characters in total.
        /// </summary>
        public static bool IsNamespace(ReadOnlySpan<char> text)
        {
            if (text.Length == 0 || text.Length > ProtocolLimits.NamespaceLength || !IsLetter(text[0])) return false;
            foreach (var c in text)
                if (!IsLetter(c) && (c < '0' || c > '9') && c != '_') return false;
            return true;
        }

        /// <returns>The namespace.</returns>
        /// <exception cref="InputException">The text is not a robot's namespace.</exception>
        public static string RequireNamespace(string text) => IsNamespace(text) ? text : throw new InputException(
            RobotMessages.NamespaceInvalid(text, ProtocolLimits.NamespaceLength));

        static bool IsLetter(char c) => (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    }
}
