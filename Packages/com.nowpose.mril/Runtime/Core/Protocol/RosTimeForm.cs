namespace Nowpose.Protocol
{
    /// <summary>Notation of a ROS time in JSON.</summary>
    enum RosTimeForm
    {
        /// <summary>ROS 2: <c>sec</c> and <c>nanosec</c>; also used if a client specifies no type.</summary>
        Sec,

        /// <summary>ROS 1: <c>secs</c> and <c>nsecs</c>.</summary>
        Secs,
    }
}
