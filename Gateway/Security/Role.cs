namespace Nowpose.Gateway.Security;

/// <summary>What a client may do.</summary>
public enum Role
{
    /// <summary>Subscribe, and publish its own diagnostics and what it shows itself.</summary>
    Observer,

    /// <summary>Also publish joint states, trajectories and the robot description.</summary>
    Source,

    /// <summary>An observer that may also switch the recorder, and see the code that pairs a headset from another machine.</summary>
    Operator,
}
