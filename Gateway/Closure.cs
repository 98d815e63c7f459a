namespace Nowpose.Gateway;

/// <summary>The reason why a connection was refused or closed.</summary>
public enum Closure
{
    ByPeer,
    Stopped,

    /// <summary>The gateway had reached its connection limit.</summary>
    ConnectionLimit,

    /// <summary>The source had its maximum number of connections.</summary>
    SourceLimit,

    /// <summary>Too few file descriptors were left for the connection.</summary>
    DescriptorLimit,

    TlsHandshake,

    /// <summary>The token was missing or unknown.</summary>
    Token,

    /// <summary>The request came from a browser page of another origin.</summary>
    Origin,

    /// <summary>On the sync port, an invalid frame or a frame of a kind not allowed at that point; on the WebSocket, a protocol violation.</summary>
    MalformedFrame,

    /// <summary>The client sent more time requests per second than allowed.</summary>
    TooManyRequests,

    /// <summary>Timeout: nothing was received, no pong was received, or the client did not read what was sent.</summary>
    Silence,

    /// <summary>The client reads so slowly that each sample would be more than a second old when read.</summary>
    SlowReader,

    /// <summary>The client sent an oversized message that did not end within the limits for skipping a message.</summary>
    EndlessMessage,

    /// <summary>Internal error of the gateway; see the log.</summary>
    Failure,
}
