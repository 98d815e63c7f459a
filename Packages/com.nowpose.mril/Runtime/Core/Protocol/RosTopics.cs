using System;

namespace Nowpose.Protocol
{
    /// <summary>Names of the topics, types and services, and what a type name says about its sender.</summary>
    public static class RosTopics
    {
        public const string JointStates = "/joint_states";
        public const string JointTrajectory = "/joint_trajectory";
        public const string RobotDescription = "/robot_description";
        public const string Diagnostics = "/nowpose/diagnostics";
        public const string GetTime = "/rosapi/get_time";

        public const string JointStateType = "sensor_msgs/msg/JointState";
        public const string JointTrajectoryType = "trajectory_msgs/msg/JointTrajectory";
        public const string StringType = "std_msgs/msg/String";
        public const string DiagnosticsType = "diagnostic_msgs/msg/DiagnosticArray";

        /// <summary>ROS 1 spells a type package/Name, ROS 2 package/msg/Name; a client that names none gets the newer form.</summary>
        public static RosTimeForm TimeFormOf(string type) =>
            string.IsNullOrEmpty(type) || type.Contains("/msg/", StringComparison.Ordinal) ? RosTimeForm.Sec : RosTimeForm.Secs;
    }
}
