namespace Nowpose.Gateway.Security;

/// <summary>What a client may do.</summary>
public enum Role
{
    /// <summary>Subscribe, and publish its own diagnostics.</summary>
    Observer,

    /// <summary>Also publish joint states, trajectories and the robot description.</summary>
    Source,
}
