namespace Nowpose.Network
{
    /// <summary>Source of the control time.</summary>
    public enum ControlClockSource
    {
        /// <summary>The gateway's clock sync, over a separate TCP connection.</summary>
        ClockSync,

        /// <summary>A rosbridge server without a gateway: its service /rosapi/get_time, over the WebSocket of the joint positions.</summary>
        RosTime,
    }
}
