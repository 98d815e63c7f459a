using System.Net;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway;

/// <summary>What a gateway is started with; immutable. The defaults serve this machine only, as the protocol says.</summary>
public sealed record GatewayOptions
{
    public IPAddress Bind { get; init; } = IPAddress.Loopback;

    /// <summary>0 takes any free one.</summary>
    public int SyncPort { get; init; } = ProtocolLimits.SyncPort;

    /// <summary>0 takes any free one.</summary>
    public int WebSocketPort { get; init; } = ProtocolLimits.WebSocketPort;

    /// <summary>With its private key, for TLS on both ports; null for plain connections. Its dates are not checked here.</summary>
    public X509Certificate2 Certificate { get; init; }

    public TokenList Tokens { get; init; } = TokenList.None;

    /// <summary>The headsets that were paired, and may connect as observers; null for a gateway that pairs none.</summary>
    public HeadsetList Headsets { get; init; }

    /// <summary>Name of the cell, which the page of pairing begins with; null for none.</summary>
    public string Cell { get; init; }

    /// <summary>Of how long codes are worth something.</summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>Allows plain connections from other machines: on a network that is trusted.</summary>
    public bool AllowInsecureLan { get; init; }

    /// <summary>Of each of the two servers.</summary>
    public int MaxConnections { get; init; } = 64;

    /// <summary>Messages a subscription may keep waiting when its client does not say.</summary>
    public int QueueLength { get; init; } = 16;

    /// <summary>Of a connection, for the time over TCP as for that over HTTP.</summary>
    public int SyncRequestsPerSecond { get; init; } = ProtocolLimits.SyncRequestsPerSecond;
    public TimeSpan SyncSilence { get; init; } = ProtocolLimits.SyncSilence;
    public TimeSpan TokenTimeout { get; init; } = ProtocolLimits.TokenTimeout;
    public TimeSpan PingInterval { get; init; } = ProtocolLimits.PingInterval;
    public TimeSpan PongTimeout { get; init; } = ProtocolLimits.PongTimeout;
    public TimeSpan MessageTimeout { get; init; } = ProtocolLimits.MessageTimeout;

    /// <summary>How long, and how many bytes, a message that is already dropped is read on to get past it; then the connection ends.</summary>
    public TimeSpan DrainTimeout { get; init; } = TimeSpan.FromSeconds(5);
    public int DrainBytes { get; init; } = 16 * 1024 * 1024;

    /// <summary>Whether a client without one is refused.</summary>
    internal bool AsksForTokens => !Tokens.IsEmpty || Headsets != null;

    /// <summary>The role of a token, or null when it is none of those that are accepted.</summary>
    internal Role? RoleOf(string token) => Tokens.RoleOf(token) ?? (Headsets?.Knows(token) == true ? Role.Observer : null);

    internal bool IsLoopback => IPAddress.IsLoopback(Bind);

    /// <exception cref="InputException">The combination would send tokens or joint positions openly, or makes no sense.</exception>
    internal void Check()
    {
        if (Certificate == null && !IsLoopback && !Tokens.IsEmpty)
            throw new InputException($"--tokens without --tls on {Bind}: tokens travel over TLS or loopback only; add --tls or bind to loopback");
        if (Certificate == null && !IsLoopback && Headsets != null)
            throw new InputException($"--pairing without --certificate on {Bind}: tokens travel over TLS or loopback only; add it or bind to loopback");
        if (Certificate == null && !IsLoopback && !AllowInsecureLan)
            throw new InputException($"--bind {Bind}: plain connections from other machines need --insecure-lan; better add --tls");
        if (Certificate is { HasPrivateKey: false })
            throw new InputException("--certificate: has no private key, which a server needs");
        CheckPort("--sync-port", SyncPort);
        CheckPort("--ws-port", WebSocketPort);
        if (MaxConnections < 1)
            throw new InputException($"--max-connections {MaxConnections}: at least 1");
    }

    static void CheckPort(string option, int port)
    {
        if (port is < 0 or > IPEndPoint.MaxPort)
            throw new InputException($"{option} {port}: allowed are 0 (any free one) to {IPEndPoint.MaxPort}");
    }
}
