namespace Nowpose.Network
{
    /// <summary>Whom a headset asks for the control time.</summary>
    public enum ControlClockSource
    {
        /// <summary>The gateway's clock sync, a TCP connection of its own.</summary>
        ClockSync,

        /// <summary>A rosbridge server without a gateway: its service /rosapi/get_time, over the WebSocket of the joint positions.</summary>
        RosTime,
    }
}
