using System.Collections.Generic;
using Nowpose.Protocol.Cell;

namespace Nowpose.Protocol
{
    /// <summary>One rosbridge v2 message. Fields that its operation does not use are null or zero. The reader reuses the object.</summary>
    sealed class RosbridgeMessage
    {
        internal RosbridgeMessage() { }

        /// <summary>The operation; <see cref="RosbridgeOp.Unknown"/> also if the envelope of a message cannot be read.</summary>
        public RosbridgeOp Op { get; internal set; }

        /// <summary>The operation as written, even if it is <see cref="RosbridgeOp.Unknown"/>.</summary>
        public string OpName { get; internal set; }

        public RequestId Id { get; internal set; }
        public string Topic { get; internal set; }

        /// <summary><see cref="Topic"/>, split into a robot's namespace and the robot's topic.</summary>
        public RobotTopic RobotTopic { get; internal set; }

        public string Type { get; internal set; }
        public string Service { get; internal set; }

        /// <summary>Minimum interval between two messages of a subscription, in ms; 0 for no limit.</summary>
        public int ThrottleRateMs { get; internal set; }

        /// <summary>Queue capacity of a subscription in messages; 0 for the server's default.</summary>
        public int QueueLength { get; internal set; }

        /// <summary>Level of a status: error, warning, info or none.</summary>
        public string Level { get; internal set; }

        /// <summary>Text of a status, or the reason in the response of a failed call.</summary>
        public string Text { get; internal set; }

        /// <summary>Body of a publication on /joint_states, in any namespace.</summary>
        public JointStateMessage JointState { get; internal set; }

        /// <summary>Body of a publication on /nowpose/displayed: the displayed joints of a headset, which are not samples of the robot.</summary>
        public JointStateMessage Displayed { get; internal set; }

        /// <summary>Body of a publication on /joint_trajectory, in any namespace.</summary>
        public JointTrajectoryMessage JointTrajectory { get; internal set; }

        /// <summary>Text of a publication: the URDF on /robot_description, in any namespace, or the version on /nowpose/version.</summary>
        public string Data { get; internal set; }

        /// <summary>Body of a publication on /tf or /tf_static.</summary>
        public TransformsMessage Transforms { get; internal set; }

        /// <summary>Body of a publication on /signals.</summary>
        public SignalsMessage Signals { get; internal set; }

        /// <summary>Body of a publication on /nowpose/diagnostics.</summary>
        public DiagnosticsMessage Diagnostics { get; internal set; }

        /// <summary>Body of a publication on /nowpose/joint_status.</summary>
        public JointStatusMessage JointStatus { get; internal set; }

        /// <summary>Body of a publication on /nowpose/signal_status; its joints are signals.</summary>
        public JointStatusMessage SignalStatus { get; internal set; }

        /// <summary>Whether the call to which this service response belongs succeeded.</summary>
        public bool Result { get; internal set; }

        /// <summary>Control time in a response from /rosapi/get_time; null for other messages and failed calls.</summary>
        public ControlTime? Time { get; internal set; }

        /// <summary>
        /// Namespaces of the robots whose joint positions have a topic, in alphabetical order, in a response from /rosapi/topics; null for other
        /// messages and failed calls.
        /// </summary>
        public IReadOnlyList<string> Namespaces { get; internal set; }

        /// <summary>
        /// Values in the response from a service whose name begins with <see cref="RosTopics.PlantTime"/>; null for other messages and failed calls.
        /// </summary>
        public PlantTimeMessage PlantTime { get; internal set; }

        internal void Clear()
        {
            Op = RosbridgeOp.Unknown;
            Id = default;
            OpName = Topic = Type = Service = Level = Text = Data = null;
            ThrottleRateMs = QueueLength = 0;
            JointState = Displayed = null;
            JointTrajectory = null;
            RobotTopic = null;
            Transforms = null;
            Signals = null;
            Diagnostics = null;
            JointStatus = SignalStatus = null;
            Result = true;
            Time = null;
            Namespaces = null;
            PlantTime = null;
        }
    }
}
