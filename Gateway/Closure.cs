namespace Nowpose.Gateway;

/// <summary>Why a connection was refused or closed.</summary>
public enum Closure
{
    ByPeer,
    Stopped,

    /// <summary>More connections than the gateway bears.</summary>
    ConnectionLimit,

    TlsHandshake,

    /// <summary>No or an unknown token.</summary>
    Token,

    /// <summary>A browser page of another origin.</summary>
    Origin,

    /// <summary>Bytes that are no sync frame or one of a kind that has no place there; what no WebSocket may send.</summary>
    MalformedFrame,

    /// <summary>More sync requests a second than allowed.</summary>
    TooManyRequests,

    /// <summary>Nothing came for too long, or no pong did, or nothing was read of what was sent.</summary>
    Silence,

    /// <summary>A message that went on beyond what is read to get past it.</summary>
    EndlessMessage,

    /// <summary>The gateway itself failed; the log says how.</summary>
    Failure,
}
