namespace Nowpose.Protocol
{
    /// <summary>State of one joint's data.</summary>
    public enum JointDataState
    {
        /// <summary>Samples arrive.</summary>
        Live,

        /// <summary>No samples, but the control system still reports the same value: the joint is assumed to be at rest.</summary>
        Rest,

        /// <summary>Samples arrived before and have stopped for an unknown reason.</summary>
        Stale,

        /// <summary>Invalid values arrive, such as NaN or a bad OPC UA status.</summary>
        Refused,

        /// <summary>The data ended during a motion, the control system has not answered for too long, or the variable was removed.</summary>
        Fault,

        /// <summary>No usable value has arrived since the start.</summary>
        Missing,
    }
}
