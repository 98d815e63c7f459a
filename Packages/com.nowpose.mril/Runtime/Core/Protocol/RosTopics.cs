using System;

namespace Nowpose.Protocol
{
    /// <summary>Names of the topics, types and services, and the time notation that a type name implies.</summary>
    static class RosTopics
    {
        public const string JointStates = "/joint_states";
        public const string JointTrajectory = "/joint_trajectory";
        public const string RobotDescription = "/robot_description";
        public const string Diagnostics = "/nowpose/diagnostics";

        /// <summary>Displayed joints of each headset: sensor_msgs/JointState, stamped with the display time; frame_id names the headset.</summary>
        public const string Displayed = "/nowpose/displayed";

        /// <summary>The joints that are not live, from the gateway: diagnostic_msgs/DiagnosticArray, see <see cref="JointStatusMessage"/>.</summary>
        public const string JointStatus = "/nowpose/joint_status";

        /// <summary>
        /// The signals whose source has ended, from the gateway: diagnostic_msgs/DiagnosticArray like <see cref="JointStatus"/>, with a signal
        /// in place of a joint.
        /// </summary>
        public const string SignalStatus = "/nowpose/signal_status";

        /// <summary>Version of the gateway: std_msgs/String, latched.</summary>
        public const string Version = "/nowpose/version";

        /// <summary>Poses of moving frames of the cell: tf2_msgs/TFMessage.</summary>
        public const string Tf = "/tf";

        /// <summary>Poses of stationary frames of the cell: tf2_msgs/TFMessage, latched per child frame.</summary>
        public const string TfStatic = "/tf_static";

        /// <summary>States of actuators and sensors of the cell: nowpose_msgs/Signals, latched per signal.</summary>
        public const string Signals = "/signals";

        public const string GetTime = "/rosapi/get_time";

        /// <summary>
        /// Name of <see cref="GetTime"/> to which a rosbridge adds its own namespace. From rosbridge_suite 2.2.0, a rosapi in a namespace has its
        /// services there.
        /// </summary>
        public const string GetTimeOfNamespace = "rosapi/get_time";

        public const string GetTopics = "/rosapi/topics";

        /// <summary>Prefix of the adapters' services that return the time of a control system; the name of the clock follows.</summary>
        public const string PlantTime = "/nowpose/plant_time/";

        // Type names in the notation of ROS 1. The rosbridge of ROS 2 accepts it, too; the rosbridge of ROS 1 rejects the notation of ROS 2.
        public const string JointStateType = "sensor_msgs/JointState";
        public const string JointTrajectoryType = "trajectory_msgs/JointTrajectory";
        public const string StringType = "std_msgs/String";
        public const string DiagnosticsType = "diagnostic_msgs/DiagnosticArray";

        public const string TransformsType = "tf2_msgs/TFMessage";
        public const string SignalsType = "nowpose_msgs/Signals";

        /// <summary>Returns the time notation of a type: package/Name means ROS 1; package/msg/Name, or no type, means ROS 2.</summary>
        public static RosTimeForm TimeFormOf(string type) =>
            string.IsNullOrEmpty(type) || type.Contains("/msg/", StringComparison.Ordinal) ? RosTimeForm.Sec : RosTimeForm.Secs;
    }
}
