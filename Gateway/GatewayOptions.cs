using System.Net;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway;

/// <summary>The immutable settings of a gateway. With the defaults, only clients on this machine can connect, as the protocol requires.</summary>
public sealed record GatewayOptions
{
    readonly TokenList _adapters;
    readonly ServerCertificate _certificate;

    public GatewayOptions() => _adapters = new TokenList([(AdapterToken, Role.Source)]);

    public IPAddress Bind { get; init; } = IPAddress.Loopback;

    /// <summary>Other host names and addresses under which browsers open the gateway's pages, beside those of this machine.</summary>
    public IReadOnlyList<string> HostNames { get; init; } = [];

    /// <summary>
    /// Name of the plant's clock that is C1. Null selects the first clock that an adapter offers, and the gateway's own clock until then.
    /// <see cref="PlantClocks.Own"/> always selects the gateway's own clock.
    /// </summary>
    public string ControlClock { get; init; }

    /// <summary>Names of the plants' clocks that only adapters of this gateway may serve, because another source could give a wrong time.</summary>
    public IReadOnlyCollection<string> ReservedClocks { get; init; } = [];

    /// <summary>TCP port of the clock synchronisation; 0 for any free port.</summary>
    public int SyncPort { get; init; } = ProtocolLimits.SyncPort;

    /// <summary>Port of the WebSocket; 0 for any free port.</summary>
    public int WebSocketPort { get; init; } = ProtocolLimits.WebSocketPort;

    /// <summary>Certificate with private key, for TLS on both ports; null for plain connections. Its validity dates are not checked.</summary>
    /// <remarks>The newest certificate of <see cref="CertificateFile"/> if that is set.</remarks>
    public X509Certificate2 Certificate
    {
        get => ServerCertificate?.Certificate;
        init => _certificate = value == null ? null : new ServerCertificate(value, []);
    }

    /// <summary>File of a certificate that is renewed while the gateway runs; null for a fixed certificate.</summary>
    public CertificateFile CertificateFile { get; init; }

    public TokenList Tokens { get; init; } = TokenList.None;

    /// <summary>The paired headsets, which may connect as observers; null for a gateway without pairing.</summary>
    public HeadsetList Headsets { get; init; }

    /// <summary>Name of the cell, proposed on the pairing page; null if the cell has no name.</summary>
    public string Cell { get; init; }

    /// <summary>The folder for recordings; null for a gateway that does not record.</summary>
    public string Recordings { get; init; }

    /// <summary>Whether the gateway is ready only after sources have sent joint positions.</summary>
    public bool ExpectsSources { get; init; }

    /// <summary>
    /// The time source of the gateway, for example for pairing codes, logins, the status and the names of recordings. Only sockets and clocks use the
    /// system's time instead.
    /// </summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>System clock and counter, with which the stamps of sources are compared.</summary>
    internal TimeProvider SystemClock { get; init; } = TimeProvider.System;

    /// <summary>Allows plain connections from other machines, for a trusted network.</summary>
    public bool AllowInsecureLan { get; init; }

    /// <summary>Maximum number of connections of each of the two servers.</summary>
    public int MaxConnections { get; init; } = 256;

    /// <summary>Number of additional WebSocket connections for sources and operators, so that observers cannot lock them out.</summary>
    internal const int ReservedConnections = 16;

    /// <summary>Number of WebSocket connections at which a further client is refused. Without tokens, every client has the same maximum.</summary>
    internal int MaxConnectionsFor(Role role) => AsksForTokens && role != Role.Observer ? MaxConnections + ReservedConnections : MaxConnections;

    /// <summary>
    /// Maximum number of connections to both ports with the token of one source and from one address. Several sources may share a token, and none of
    /// them may use all connections. A connection above the maximum is refused.
    /// </summary>
    internal int MaxConnectionsOfSource => MaxConnectionsFor(Role.Source) / 4;

    /// <summary>
    /// Maximum number of connections from one address, on each of the two ports, before authentication. The number applies separately to
    /// connections before and after the TLS handshake. At the limit, a new connection replaces the oldest one.
    /// </summary>
    public int MaxPendingConnections { get; init; } = 32;

    /// <summary>Maximum number of connections to the WebSocket port before authentication, from all addresses together.</summary>
    internal int MaxPendingInAll => Math.Max(MaxConnections, MaxPendingConnections);

    /// <summary>
    /// Delay of each response to an address that has sent too many wrong tokens. Shorter than the time for which a headset waits for a response.
    /// </summary>
    public TimeSpan WrongTokenDelay { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>Maximum number of messages that a source may send per second. Further messages are dropped before they are read.</summary>
    /// <remarks>The default allows four topics at a control rate of 1 kHz.</remarks>
    public int SourceMessagesPerSecond { get; init; } = 4000;

    /// <summary>Maximum number of messages that any other client may send per second. Further messages are dropped before they are read.</summary>
    /// <remarks>The default allows diagnostics and displayed poses.</remarks>
    public int ObserverMessagesPerSecond { get; init; } = 250;

    /// <summary>Queue length of a subscription in messages, if its client does not set one.</summary>
    public int QueueLength { get; init; } = 16;

    /// <summary>Maximum number of time requests of one connection per second, over TCP and over HTTP.</summary>
    public int SyncRequestsPerSecond { get; init; } = ProtocolLimits.SyncRequestsPerSecond;
    public TimeSpan SyncSilence { get; init; } = ProtocolLimits.SyncSilence;
    public TimeSpan TokenTimeout { get; init; } = ProtocolLimits.TokenTimeout;
    public TimeSpan PingInterval { get; init; } = ProtocolLimits.PingInterval;
    public TimeSpan PongTimeout { get; init; } = ProtocolLimits.PongTimeout;
    public TimeSpan MessageTimeout { get; init; } = ProtocolLimits.MessageTimeout;

    /// <summary>Minimum rate at which a client must read a page. At this rate, the longest page takes half a minute.</summary>
    public int AnswerBytesPerSecond { get; init; } = 32 * 1024;

    /// <summary>Maximum time for skipping the rest of a message that was dropped. Afterwards, the gateway closes the connection.</summary>
    public TimeSpan DrainTimeout { get; init; } = TimeSpan.FromSeconds(5);
    /// <summary>Maximum number of bytes of a dropped message that are skipped. Beyond it, the gateway closes the connection.</summary>
    public int DrainBytes { get; init; } = 16 * 1024 * 1024;

    internal ServerCertificate ServerCertificate => CertificateFile?.Current ?? _certificate;

    /// <summary>Expiry of the certificate, UTC, after which headsets refuse it; null without TLS.</summary>
    internal DateTime? CertificateExpires => Certificate?.NotAfter.ToUniversalTime();

    /// <summary>Whether a client without a token is refused.</summary>
    internal bool AsksForTokens => !Tokens.IsEmpty || Headsets != null;

    /// <summary>Gets the role of a token, or null if it is not accepted.</summary>
    internal Role? RoleOf(string token) => RoleOf(TokenList.HashOf(token));

    /// <inheritdoc cref="RoleOf(string)"/>
    /// <param name="tokenHash">Hash from <see cref="TokenList.HashOf"/>.</param>
    internal Role? RoleOf(byte[] tokenHash) =>
        _adapters.RoleOf(tokenHash) ?? Tokens.RoleOf(tokenHash) ?? (Headsets?.Contains(tokenHash) == true ? Role.Observer : null);

    /// <summary>The token of the adapters that this gateway starts. It has the role of a source and is generated at each start.</summary>
    internal string AdapterToken { get; } = Convert.ToHexString(RandomNumberGenerator.GetBytes(32));

    /// <summary>Whether a token is the one of the adapters that this gateway starts.</summary>
    /// <param name="tokenHash">Hash of the token; null for a client without a token.</param>
    internal bool IsOwnAdapter(byte[] tokenHash) => tokenHash != null && _adapters.RoleOf(tokenHash) != null;

    /// <summary>Gets the hash of a token for a log line; null for a weak token, which a reader of the log could find by its hash.</summary>
    internal byte[] LoggedHash(byte[] tokenHash) => tokenHash != null && Tokens.IsWeak(tokenHash) ? null : tokenHash;

    /// <summary>Whether a token that was accepted earlier still has the same role. Tokens can be revoked while connections are open.</summary>
    /// <param name="tokenHash">Hash of the token; null for a client that connected without a token.</param>
    internal bool Holds(byte[] tokenHash, Role role) => !AsksForTokens || (tokenHash != null && RoleOf(tokenHash) == role);

    /// <summary>Reads the files of tokens, headsets and certificate again if they have changed.</summary>
    internal void Follow()
    {
        Tokens.Follow();
        Headsets?.Follow();
        _ = Certificate;
    }

    /// <summary>Paths of the files of tokens, headsets and certificate whose present content is not used completely, with the faults.</summary>
    internal IEnumerable<(string Path, string Fault)> FileFaults =>
        new[] { (Tokens.Path, Tokens.Fault), (Headsets?.Path, Headsets?.Fault), (CertificateFile?.Path, CertificateFile?.Fault) }
            .Where(one => one.Item2 != null);

    /// <summary>Paths of the files that other users must not read: tokens, paired headsets and the private key.</summary>
    internal IEnumerable<string> SecretFiles =>
        new[] { Tokens.Path, Headsets?.Path, CertificateFile?.KeyPath }.Where(path => path != null);

    internal bool IsLoopback => IPAddress.IsLoopback(Bind);

    /// <summary>Checks the combination of the settings.</summary>
    /// <exception cref="InputException">
    /// Two settings contradict each other, tokens or joint positions would be sent unencrypted, or the system allows too few file descriptors.
    /// </exception>
    internal void Check()
    {
        CheckEncryption(Certificate != null, !Tokens.IsEmpty, Headsets != null);
        CheckPorts();
        CheckConnections();
    }

    /// <summary>Checks that other machines connect with TLS, or may connect without it.</summary>
    /// <exception cref="InputException">Tokens or joint positions would be sent unencrypted.</exception>
    internal void CheckEncryption(bool encrypts, bool hasTokens, bool pairsHeadsets)
    {
        if (encrypts || IsLoopback) return;
        var faults = EncryptionFaults(hasTokens, pairsHeadsets).ToArray();
        if (faults.Length > 0) throw new WrongEntriesException(faults);
    }

    IEnumerable<string> EncryptionFaults(bool hasTokens, bool pairsHeadsets)
    {
        if (hasTokens) yield return AddressOptionMessages.TokensWithoutTls(Bind);
        if (pairsHeadsets) yield return AddressOptionMessages.PairingWithoutCertificate(Bind);
        // Tokens and pairing need encryption also on a trusted network.
        if (!hasTokens && !pairsHeadsets && !AllowInsecureLan) yield return AddressOptionMessages.PlainBind(Bind);
    }

    /// <summary>Checks that the two ports differ.</summary>
    /// <exception cref="InputException">The ports are equal.</exception>
    internal void CheckPorts()
    {
        if (SyncPort == WebSocketPort && SyncPort != 0)
            throw new InputException(AddressOptionMessages.SamePorts(OptionOfTheSamePort, SyncPort));
    }

    /// <summary>Checks the maximum number of connections.</summary>
    /// <exception cref="InputException">The system allows too few file descriptors.</exception>
    internal void CheckConnections() => DescriptorLimit.Check(MaxConnections);

    // The option to name in the message: the one whose value is not the default.
    string OptionOfTheSamePort => WebSocketPort == ProtocolLimits.WebSocketPort ? "--sync-port" : "--ws-port";
}
