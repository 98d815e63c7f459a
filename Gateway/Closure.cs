namespace Nowpose.Gateway;

/// <summary>Why a connection was refused or closed.</summary>
public enum Closure
{
    ByPeer,
    Stopped,

    /// <summary>Connection limit of the gateway reached.</summary>
    ConnectionLimit,

    TlsHandshake,

    /// <summary>Missing or unknown token.</summary>
    Token,

    /// <summary>A browser page of another origin.</summary>
    Origin,

    /// <summary>Invalid sync frame, or one of a kind that is not allowed at this point; on the WebSocket, a violation of the protocol.</summary>
    MalformedFrame,

    /// <summary>More sync requests per second than allowed.</summary>
    TooManyRequests,

    /// <summary>Timeout: nothing was received, no pong was received, or the client did not read what was sent.</summary>
    Silence,

    /// <summary>The client reads too slowly: every sample would be more than a second old when it is read.</summary>
    SlowReader,

    /// <summary>An oversized message that did not end within the limit for skipping it.</summary>
    EndlessMessage,

    /// <summary>Internal error of the gateway; see the log.</summary>
    Failure,
}
