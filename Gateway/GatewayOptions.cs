using System.Net;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway;

/// <summary>What a gateway is started with; immutable. The defaults serve this machine only, as the protocol says.</summary>
public sealed record GatewayOptions
{
    const int GreatestRate = 100_000;

    readonly TokenList _adapters;

    public GatewayOptions() => _adapters = new TokenList([(AdapterToken, Role.Source)]);

    public IPAddress Bind { get; init; } = IPAddress.Loopback;

    /// <summary>
    /// Name of the plant's clock that is C1; null for the first that an adapter offers, the gateway's own until then;
    /// <see cref="PlantClocks.Own"/> for the gateway's in any case.
    /// </summary>
    public string ControlClock { get; init; }

    /// <summary>0 takes any free one.</summary>
    public int SyncPort { get; init; } = ProtocolLimits.SyncPort;

    /// <summary>0 takes any free one.</summary>
    public int WebSocketPort { get; init; } = ProtocolLimits.WebSocketPort;

    /// <summary>With its private key, for TLS on both ports; null for plain connections. Its dates are not checked here.</summary>
    /// <remarks>The newest of <see cref="CertificateFile"/> where there is one.</remarks>
    public X509Certificate2 Certificate { get => CertificateFile?.Current ?? field; init; }

    /// <summary>Where the certificate is renewed while the gateway runs; null for one that is not.</summary>
    public CertificateFile CertificateFile { get; init; }

    public TokenList Tokens { get; init; } = TokenList.None;

    /// <summary>The headsets that were paired, and may connect as observers; null for a gateway that pairs none.</summary>
    public HeadsetList Headsets { get; init; }

    /// <summary>Name of the cell, which the page of pairing begins with; null for none.</summary>
    public string Cell { get; init; }

    /// <summary>The folder for recordings; null for a gateway that does not record.</summary>
    public string Recordings { get; init; }

    /// <summary>Whether joint positions should be coming: until they do, the gateway is not ready.</summary>
    public bool ExpectsSources { get; init; }

    /// <summary>
    /// Of what people see and set: codes and logins that expire, names in use, lines of the log that are alike, names of recordings. Sockets
    /// and clocks go by the system's.
    /// </summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>Clock and counter of the system, which the stamps of sources are compared with.</summary>
    internal TimeProvider SystemClock { get; init; } = TimeProvider.System;

    /// <summary>Allows plain connections from other machines: on a network that is trusted.</summary>
    public bool AllowInsecureLan { get; init; }

    /// <summary>Of each of the two servers.</summary>
    public int MaxConnections { get; init; } = 256;

    /// <summary>
    /// Maximum number of connections of one address, on each of the two ports, that have not yet been let in. As many again when they
    /// have completed a handshake. A newer one replaces the oldest.
    /// </summary>
    public int MaxPendingConnections { get; init; } = 32;

    /// <summary>Maximum number of connections to the WebSocket port that have not yet been let in, of all addresses.</summary>
    internal int MaxPendingInAll => Math.Max(MaxConnections, MaxPendingConnections);

    /// <summary>Interval of the answers to wrong tokens of one address that has sent too many of them.</summary>
    public TimeSpan WrongTokenDelay { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>Messages that a client may send within a second: what comes beyond is dropped before it is read.</summary>
    /// <remarks>For sources: four topics at the 1 kHz of a fast control cycle. For others: diagnostics and what a headset shows, and room.</remarks>
    public int SourceMessagesPerSecond { get; init; } = 4000;

    /// <inheritdoc cref="SourceMessagesPerSecond"/>
    public int ObserverMessagesPerSecond { get; init; } = 250;

    /// <summary>Messages a subscription may keep waiting when its client does not say.</summary>
    public int QueueLength { get; init; } = 16;

    /// <summary>Of a connection, for the time over TCP as for that over HTTP.</summary>
    public int SyncRequestsPerSecond { get; init; } = ProtocolLimits.SyncRequestsPerSecond;
    public TimeSpan SyncSilence { get; init; } = ProtocolLimits.SyncSilence;
    public TimeSpan TokenTimeout { get; init; } = ProtocolLimits.TokenTimeout;
    public TimeSpan PingInterval { get; init; } = ProtocolLimits.PingInterval;
    public TimeSpan PongTimeout { get; init; } = ProtocolLimits.PongTimeout;
    public TimeSpan MessageTimeout { get; init; } = ProtocolLimits.MessageTimeout;

    /// <summary>How fast a page must be taken by whoever asked for it: half a minute for the longest there is.</summary>
    public int AnswerBytesPerSecond { get; init; } = 32 * 1024;

    /// <summary>How long, and how many bytes, a message that is already dropped is read on to get past it; then the connection ends.</summary>
    public TimeSpan DrainTimeout { get; init; } = TimeSpan.FromSeconds(5);
    public int DrainBytes { get; init; } = 16 * 1024 * 1024;

    /// <summary>When headsets will refuse the certificate, UTC; null without TLS.</summary>
    internal DateTime? CertificateExpires => Certificate?.NotAfter.ToUniversalTime();

    /// <summary>Whether a client without one is refused.</summary>
    internal bool AsksForTokens => !Tokens.IsEmpty || Headsets != null;

    /// <summary>The role of a token, or null when it is none of those that are accepted.</summary>
    internal Role? RoleOf(string token) => RoleOf(TokenList.HashOf(token));

    /// <inheritdoc cref="RoleOf(string)"/>
    /// <param name="tokenHash">As <see cref="TokenList.HashOf"/> makes it; asked again it tells whether the token still counts.</param>
    internal Role? RoleOf(byte[] tokenHash) =>
        _adapters.RoleOf(tokenHash) ?? Tokens.RoleOf(tokenHash) ?? (Headsets?.Knows(tokenHash) == true ? Role.Observer : null);

    /// <summary>A source's, for the adapters that this gateway starts; another one at each start.</summary>
    internal string AdapterToken { get; } = Convert.ToHexString(RandomNumberGenerator.GetBytes(32));

    /// <summary>Whether what let somebody in still does, as the same: tokens are revoked while connections are open.</summary>
    /// <param name="tokenHash">Of the token; null for who needed none.</param>
    internal bool Holds(byte[] tokenHash, Role role) => !AsksForTokens || (tokenHash != null && RoleOf(tokenHash) == role);

    /// <summary>Reads again what has changed in files.</summary>
    internal void Follow()
    {
        Tokens.Follow();
        Headsets?.Follow();
        _ = Certificate;
    }

    /// <summary>Files that nobody else should read: of tokens, their hashes, and the key.</summary>
    internal IEnumerable<string> SecretFiles =>
        new[] { Tokens.Path, Headsets?.Path, CertificateFile?.KeyPath }.Where(path => path != null);

    internal bool IsLoopback => IPAddress.IsLoopback(Bind);

    /// <exception cref="InputException">The combination would send tokens or joint positions openly, or makes no sense.</exception>
    internal void Check() => Check(Headsets != null);

    /// <inheritdoc cref="Check()"/>
    internal void Check(bool pairsHeadsets)
    {
        if (Certificate == null && !IsLoopback && !Tokens.IsEmpty)
            throw new InputException($"--tokens without --tls on {Bind}: tokens travel over TLS or loopback only; add --tls or bind to loopback");
        if (Certificate == null && !IsLoopback && pairsHeadsets)
            throw new InputException($"--pairing without --certificate on {Bind}: tokens travel over TLS or loopback only; add it or bind to loopback");
        if (Certificate == null && !IsLoopback && !AllowInsecureLan)
            throw new InputException($"--bind {Bind}: plain connections from other machines need --insecure-lan; better add --tls");
        if (Certificate is { HasPrivateKey: false })
            throw new InputException("--certificate: has no private key, which a server needs");
        CheckPort("--sync-port", SyncPort);
        CheckPort("--ws-port", WebSocketPort);
        if (SyncPort == WebSocketPort && SyncPort != 0)
            throw new InputException($"{OptionOfTheSamePort} {SyncPort}: both ports are the same; each needs one of its own");
        if (MaxConnections < 1)
            throw new InputException($"--max-connections {MaxConnections}: at least 1");
        DescriptorLimit.Check(MaxConnections);
        CheckRate(nameof(SourceMessagesPerSecond), SourceMessagesPerSecond);
        CheckRate(nameof(ObserverMessagesPerSecond), ObserverMessagesPerSecond);
        CheckRate(nameof(SyncRequestsPerSecond), SyncRequestsPerSecond);
    }

    // Each connection keeps the time of as many.
    static void CheckRate(string option, int perSecond)
    {
        if (perSecond is < 1 or > GreatestRate)
            throw new InputException($"{option} {perSecond}: allowed are 1 to {GreatestRate}");
    }

    // The one that was set, where the other is what it is without.
    string OptionOfTheSamePort => WebSocketPort == ProtocolLimits.WebSocketPort ? "--sync-port" : "--ws-port";

    static void CheckPort(string option, int port)
    {
        if (port is < 0 or > IPEndPoint.MaxPort)
            throw new InputException($"{option} {port}: allowed are 0 (any free one) to {IPEndPoint.MaxPort}");
    }
}
