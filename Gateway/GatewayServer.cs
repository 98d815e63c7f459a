using System.Net;
using System.Net.Sockets;
using System.Security.Authentication;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Codes;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Operations;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Sync;
using Nowpose.Pairing;

namespace Nowpose.Gateway;

/// <summary>The gateway between control system and headsets: clock sync over TCP, rosbridge v2 over WebSocket, and the message hub.</summary>
public sealed class GatewayServer : IAsyncDisposable
{
    static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(3);

    readonly GatewayOptions _options;
    readonly Action<string> _unlimitedLog;
    readonly RateLimitedLog _log;
    readonly AccessWatch _access;
    readonly RosbridgeServer _rosbridge;
    readonly VlcPage _page;
    readonly PairingRoutes _pairing;
    readonly SyncServer _sync;
    readonly PendingConnections _webPending;
    readonly ClockComparison _comparison;
    readonly GatewayStatus _status;
    readonly WebApplication _web;

    // Opens the sync port and starts the sync server. StartAsync starts the web server.
    GatewayServer(GatewayOptions options, IControlClock clock, Action<string> log)
    {
        _options = options;
        _unlimitedLog = log;
        _log = NewLog();
        Hub = new MessageHub();
        PlantClocks = new PlantClocks(options.ControlClock, new StopwatchHeadsetClock(), options.ReservedClocks);
        Clock = new ServedClock(clock, PlantClocks, options.SystemClock);
        _comparison = new ClockComparison(Clock, Log);
        _access = new AccessWatch(options, Log);
        WebSocketConnections = new ConnectionCounters();
        var wrong = new WrongTokens(options.Time);
        var accessControl = new AccessControl(options, wrong, WebSocketConnections, _log.Write);
        _rosbridge = new RosbridgeServer(options, Clock, PlantClocks, Hub, accessControl, _access, WebSocketConnections, Log);
        _page = new VlcPage(options, Clock, accessControl, WebSocketConnections, Web.Pages.Vlc);
        _pairing = new PairingRoutes(options, accessControl, WebSocketConnections, Log, Web.Pages.Pairing);
        Recorder = new Recorder(options, Hub, Clock, PlantClocks, Drops, Log);
        _sync = new SyncServer(options, Clock, _access, wrong, _log.Write);
        var limits = new LimitAlarm(Hub, Log);
        var events = new EventList(options.Time, _log.Write);
        _status = new GatewayStatus(options, Clock, PlantClocks, Hub, Drops, SyncConnections, WebSocketConnections, Recorder, limits, events, Log);
        var recordings = new RecordingsFolder(options.Recordings);
        RecordingsWatch = new RecordingsWatch(Recorder, recordings, events, Log);
        _webPending = new PendingConnections(options.MaxPendingConnections, options.MaxPendingInAll);
        _web = GatewayWeb.Build(
            options, new PendingWebConnections(_webPending, WebSocketConnections, Log), WebSocketConnections, Log, _rosbridge.ServeAsync,
            _page.ServeAsync,
            _pairing.ServeAsync,
            new StatusRoutes(_status, accessControl).ServeAsync,
            new RecordingRoutes(Recorder, recordings, accessControl).ServeAsync,
            new OperationsRoutes(options, accessControl, WebSocketConnections, Web.Pages.Operations).ServeAsync);
    }

    /// <summary>Endpoint of the sync server, with the actual port even if port 0 was requested.</summary>
    public IPEndPoint SyncEndPoint => _sync.EndPoint;

    /// <summary>Endpoint of the WebSocket server, with the actual port even if port 0 was requested.</summary>
    public IPEndPoint WebSocketEndPoint { get; private set; }

    /// <summary>
    /// Addresses of the page that shows the control time as a code for cameras, one per host name; empty if the page was not built.
    /// </summary>
    public IReadOnlyList<Uri> VlcPageUris =>
        !_page.IsBuilt ? [] : [.. OwnHosts.Reachable(_options.Bind).Select(host => PageUri(host, VlcPage.Path))];

    /// <summary>Addresses of the operations page, one per host name; empty if the page was not built.</summary>
    public IReadOnlyList<Uri> OperationsPageUris =>
        Web.Pages.Operations == null ? [] : [.. OwnHosts.Reachable(_options.Bind).Select(host => PageUri(host, OperationsRoutes.Path))];

    /// <summary>Whether the gateway pairs headsets. Each paired headset receives its own token.</summary>
    public bool PairsHeadsets => _options.Headsets != null;

    /// <summary>
    /// Address of the pairing page for a browser on this machine; null if the gateway does not pair headsets or the page was not built.
    /// </summary>
    public Uri PairingPageUri => PairsHeadsets && _pairing.Page.IsBuilt ? PageUri(LocalHost, PairingLimits.Path) : null;

    /// <summary>The token that gives an adapter started by this gateway the role of a source.</summary>
    internal string AdapterToken => _options.AdapterToken;

    /// <summary>The certificate pin that headsets store; null without TLS.</summary>
    public CertificatePin Pin => _options.Certificate == null ? null : CertificatePin.Of(_options.Certificate);

    /// <summary>SHA-256 fingerprint of the certificate as browsers show it, to verify it before a token is entered; null without TLS.</summary>
    internal string Fingerprint => _options.Certificate is not { } certificate ? null
        : BitConverter.ToString(certificate.GetCertHash(HashAlgorithmName.SHA256)).Replace('-', ':');

    /// <summary>Warnings for the operator: unnecessary privileges, and secret files that other users can read.</summary>
    public IEnumerable<string> Warnings => Precautions.Of(_options, Environment.GetEnvironmentVariable("CREDENTIALS_DIRECTORY"));

    /// <summary>The log for all parts of the gateway. Its rate limit prevents clients from filling the disk.</summary>
    internal Action<string> Log => _log.Write;

    /// <summary>Creates a log with its own rate limit, so that the lines of other parts cannot suppress its lines. The caller disposes it.</summary>
    internal RateLimitedLog NewLog() => new(_unlimitedLog, Time);

    internal EventList Events => _status.Events;

    internal TimeProvider Time => _options.Time;

    public MessageHub Hub { get; }

    /// <summary>Records the messages of the hub to files while it is enabled.</summary>
    public Recorder Recorder { get; }

    internal RecordingsWatch RecordingsWatch { get; }

    /// <summary>C1 as served to headsets.</summary>
    public ServedClock Clock { get; }

    public PlantClocks PlantClocks { get; }

    /// <summary>Counters of the dropped messages from clients and to slow clients.</summary>
    internal DropCounters Drops => _rosbridge.Drops;

    public ConnectionCounters SyncConnections => _sync.Counters;
    public ConnectionCounters WebSocketConnections { get; }

    /// <summary>Number of connections to both ports that are not authenticated yet.</summary>
    internal int PendingCount => _sync.PendingCount + _webPending.Count;

    /// <summary>Number of open connections with a token. The gateway closes them when their token is revoked.</summary>
    internal int WatchedTokens => _access.Count;

    /// <summary>Starts both servers. They accept connections when this returns.</summary>
    /// <param name="clock">The gateway's own clock, served until an adapter offers the control system's clock.</param>
    /// <param name="log">Receives short lines without secrets, on any thread; null for no log.</param>
    /// <exception cref="InputException">The options contradict the protocol.</exception>
    /// <exception cref="IOException">A port is in use, or the address does not belong to this machine. Both may be temporary.</exception>
    public static async Task<GatewayServer> StartAsync(
        GatewayOptions options, IControlClock clock, Action<string> log = null, CancellationToken cancellation = default)
    {
        options.Check();
        var server = new GatewayServer(options, clock, log ?? (_ => { }));
        try
        {
            await server.StartWebAsync(cancellation);
            server._access.Start();
            server._comparison.Start();
            return server;
        }
        catch
        {
            await server.DisposeAsync();
            throw;
        }
    }

    /// <summary>Makes the gateway not ready until each of these adapters runs and reports.</summary>
    internal void Expect(IReadOnlyList<Func<AdapterState>> adapters) => _status.Expect(adapters);

    public async ValueTask DisposeAsync()
    {
        RecordingsWatch.Dispose();
        _status.Dispose();
        _comparison.Dispose();
        _access.Dispose();
        _rosbridge.Stop();
        _sync.Dispose();
        using var timeout = new CancellationTokenSource(StopTimeout);
        await _web.StopAsync(timeout.Token);
        await _web.DisposeAsync();
        _rosbridge.Dispose();
        // Closed last, so that the file contains all received messages.
        await Recorder.DisposeAsync();
        _log.Dispose();
    }

    string LocalHost => OwnHosts.IsAny(_options.Bind) ? "localhost" : OwnHosts.Reachable(_options.Bind).First();

    Uri PageUri(string host, string path) =>
        new($"{(Pin == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps)}://{host}:{WebSocketEndPoint.Port}{path}");

    async Task StartWebAsync(CancellationToken cancellation)
    {
        await _web.StartAsync(cancellation);
        var addresses = _web.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>();
        WebSocketEndPoint = new IPEndPoint(_options.Bind, new Uri(addresses.Addresses.First()).Port);
        _pairing.Page.SyncPort = SyncEndPoint.Port;
        _pairing.Page.WebSocketPort = WebSocketEndPoint.Port;
    }
}
