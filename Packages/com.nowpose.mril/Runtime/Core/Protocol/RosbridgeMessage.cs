namespace Nowpose.Protocol
{
    /// <summary>One rosbridge v2 message as read; what its operation does not have is null or zero. The reader overwrites it with the next message.</summary>
    sealed class RosbridgeMessage
    {
        internal RosbridgeMessage() { }

        public RosbridgeOp Op { get; internal set; }

        /// <summary>The operation as written, also when it is <see cref="RosbridgeOp.Unknown"/>.</summary>
        public string OpName { get; internal set; }

        public string Id { get; internal set; }
        public string Topic { get; internal set; }
        public string Type { get; internal set; }
        public string Service { get; internal set; }

        /// <summary>Shortest time between two messages of a subscription, ms; 0 for all of them.</summary>
        public int ThrottleRateMs { get; internal set; }

        /// <summary>Messages a subscription may keep waiting; 0 leaves it to the server.</summary>
        public int QueueLength { get; internal set; }

        /// <summary>Of a status: error, warning, info or none.</summary>
        public string Level { get; internal set; }

        /// <summary>Of a status: what it says. Of the response of a failed call: why.</summary>
        public string Text { get; internal set; }

        /// <summary>Of a publication on /joint_states.</summary>
        public JointStateMessage JointState { get; internal set; }

        /// <summary>Of a publication on /nowpose/displayed: what a headset shows, which is no sample of the robot.</summary>
        public JointStateMessage Displayed { get; internal set; }

        /// <summary>Of a publication on /joint_trajectory.</summary>
        public JointTrajectoryMessage JointTrajectory { get; internal set; }

        /// <summary>Of a publication on /robot_description: the URDF text.</summary>
        public string Data { get; internal set; }

        /// <summary>Of a publication on /nowpose/diagnostics.</summary>
        public DiagnosticsMessage Diagnostics { get; internal set; }

        /// <summary>Of a publication on /nowpose/joint_status.</summary>
        public JointStatusMessage JointStatus { get; internal set; }

        /// <summary>Of a service response: whether the call succeeded.</summary>
        public bool Result { get; internal set; }

        /// <summary>Of a response of /rosapi/get_time: the control time; null elsewhere and when the call failed.</summary>
        public ControlTime? Time { get; internal set; }

        /// <summary>Of a response of a service below <see cref="RosTopics.PlantTime"/>; null elsewhere and when the call failed.</summary>
        public PlantTimeMessage PlantTime { get; internal set; }

        internal void Clear()
        {
            Op = RosbridgeOp.Unknown;
            OpName = Id = Topic = Type = Service = Level = Text = Data = null;
            ThrottleRateMs = QueueLength = 0;
            JointState = Displayed = null;
            JointTrajectory = null;
            Diagnostics = null;
            JointStatus = null;
            Result = true;
            Time = null;
            PlantTime = null;
        }
    }
}
