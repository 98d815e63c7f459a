namespace Nowpose.Protocol
{
    /// <summary>How a ROS time is spelt in JSON.</summary>
    enum RosTimeForm
    {
        /// <summary>ROS 2: <c>sec</c> and <c>nanosec</c>; also when a client names no type.</summary>
        Sec,

        /// <summary>ROS 1: <c>secs</c> and <c>nsecs</c>.</summary>
        Secs,
    }
}
