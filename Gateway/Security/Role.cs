namespace Nowpose.Gateway.Security;

/// <summary>The permissions of a client.</summary>
public enum Role
{
    /// <summary>May subscribe, and publish its own diagnostics and displayed pose.</summary>
    Observer,

    /// <summary>May do the same as an observer, and publish joint states, trajectories, robot descriptions, frames and signals.</summary>
    Source,

    /// <summary>May do the same as an observer, control the recorder, and see the pairing code from another machine.</summary>
    Operator,
}
