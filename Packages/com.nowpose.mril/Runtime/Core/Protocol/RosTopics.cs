using System;

namespace Nowpose.Protocol
{
    /// <summary>Names of the topics, types and services, and what a type name says about its sender.</summary>
    static class RosTopics
    {
        public const string JointStates = "/joint_states";
        public const string JointTrajectory = "/joint_trajectory";
        public const string RobotDescription = "/robot_description";
        public const string Diagnostics = "/nowpose/diagnostics";

        /// <summary>What each headset shows: sensor_msgs/JointState, stamped with the moment of light; its frame_id is the headset's name.</summary>
        public const string Displayed = "/nowpose/displayed";

        /// <summary>The joints that are not live, from the gateway: diagnostic_msgs/DiagnosticArray, see <see cref="JointStatusMessage"/>.</summary>
        public const string JointStatus = "/nowpose/joint_status";

        public const string GetTime = "/rosapi/get_time";
        public const string GetTopics = "/rosapi/topics";

        /// <summary>Services of adapters, each with the name of a clock behind it: they tell the time of a control system.</summary>
        public const string PlantTime = "/nowpose/plant_time/";

        // In ROS 1's spelling, which the rosbridge of ROS 2 understands as well; that of ROS 1 refuses the other one, and tells only its log.
        public const string JointStateType = "sensor_msgs/JointState";
        public const string JointTrajectoryType = "trajectory_msgs/JointTrajectory";
        public const string StringType = "std_msgs/String";
        public const string DiagnosticsType = "diagnostic_msgs/DiagnosticArray";

        /// <summary>ROS 1 spells a type package/Name, ROS 2 package/msg/Name; a client that names none gets the newer form.</summary>
        public static RosTimeForm TimeFormOf(string type) =>
            string.IsNullOrEmpty(type) || type.Contains("/msg/", StringComparison.Ordinal) ? RosTimeForm.Sec : RosTimeForm.Secs;
    }
}
