namespace Nowpose.Protocol
{
    /// <summary>Whether the data of one joint arrive.</summary>
    public enum JointDataState
    {
        /// <summary>Samples arrive.</summary>
        Live,

        /// <summary>No samples, but the control system still answers with the same value: the joint is assumed at rest.</summary>
        Rest,

        /// <summary>Samples arrived before and have stopped, for an unknown reason.</summary>
        Stale,

        /// <summary>Values arrive that cannot be used, such as NaN or a bad OPC UA status.</summary>
        Refused,

        /// <summary>The data ended in mid-motion, the control system has been silent for too long, or the variable is gone.</summary>
        Fault,

        /// <summary>No usable value has arrived since the start.</summary>
        Missing,
    }
}
