namespace Nowpose.Gateway.Status.Joints;

/// <summary>State of the data of one joint.</summary>
enum JointHealth
{
    /// <summary>Samples arrive.</summary>
    Live,

    /// <summary>Silent; the adapter has read the value back and assumes that the joint is at rest.</summary>
    Rest,

    /// <summary>Samples arrived before and stopped, and no adapter explains why.</summary>
    Stale,

    /// <summary>Values arrive and cannot be used.</summary>
    Refused,

    /// <summary>The data ended in mid-motion, the silence is longer than configured, or the node is gone.</summary>
    Fault,

    /// <summary>No usable value since the start.</summary>
    Missing,
}
