namespace Nowpose.Gateway.Security;

/// <summary>The permissions of a client.</summary>
public enum Role
{
    /// <summary>May subscribe, and publish its own diagnostics and displayed pose.</summary>
    Observer,

    /// <summary>May also publish joint states, trajectories and the robot description.</summary>
    Source,

    /// <summary>An observer that may also control the recorder, and see the pairing code from another machine.</summary>
    Operator,
}
