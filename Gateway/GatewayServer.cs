using System.Net;
using System.Net.Sockets;
using System.Security.Authentication;
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
using Nowpose.Protocol;
using Nowpose.Web;

namespace Nowpose.Gateway;

/// <summary>The middleware between control system and headsets: clock sync over TCP, rosbridge v2 over WebSocket, and the hub between.</summary>
public sealed class GatewayServer : IAsyncDisposable
{
    static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(3);

    readonly GatewayOptions _options;
    readonly QuietLog _log;
    readonly AccessWatch _access;
    readonly RosbridgeServer _rosbridge;
    readonly CodePage _page;
    readonly PairingRoutes _pairing;
    readonly SyncServer _sync;
    readonly PendingConnections _webPending;
    readonly ClockComparison _comparison;
    readonly LimitAlarm _limits;
    readonly GatewayStatus _status;
    readonly WebApplication _web;

    // Nobody is served before StartAsync, but the port of the clock is taken.
    GatewayServer(GatewayOptions options, IControlClock clock, Action<string> log)
    {
        _options = options;
        _log = new QuietLog(log, options.Time);
        Hub = new MessageHub();
        PlantClocks = new PlantClocks(options.ControlClock, new StopwatchHeadsetClock());
        Clock = new ServedClock(clock, PlantClocks, options.SystemClock);
        _comparison = new ClockComparison(Clock, Log);
        _access = new AccessWatch(options, Log);
        WebSocketConnections = new ConnectionCounters();
        var wrong = new WrongTokens(options.Time);
        var door = new Door(options, wrong, WebSocketConnections, Log);
        _rosbridge = new RosbridgeServer(options, Clock, PlantClocks, Hub, door, _access, WebSocketConnections, Log);
        _page = new CodePage(options, Clock, door, WebSocketConnections, Log, LightCodePage.Html);
        _pairing = new PairingRoutes(options, door, WebSocketConnections, Log, Web.PairingPage.Html);
        Recorder = new Recorder(options, Hub, Clock, PlantClocks, Drops, Log);
        _sync = new SyncServer(options, Clock, _access, wrong, Log);
        _limits = new LimitAlarm(Hub, Log);
        var events = new EventList(options.Time, Log);
        _status = new GatewayStatus(options, Clock, PlantClocks, Hub, Drops, SyncConnections, WebSocketConnections, Recorder, _limits, events, Log);
        var recordings = new RecordingsFolder(options.Recordings);
        RecordingsWatch = new RecordingsWatch(Recorder, recordings, events, Log);
        _webPending = new PendingConnections(options.MaxPendingConnections, options.MaxPendingInAll);
        _web = GatewayWeb.Build(
            options, new PendingPlaces(_webPending, WebSocketConnections, Log), Log, _rosbridge.ServeAsync,
            _page.ServeAsync,
            _pairing.ServeAsync,
            new StatusRoutes(_status, door).ServeAsync,
            new RecordingRoutes(Recorder, recordings, door).ServeAsync,
            new OperationsRoutes(options, door, WebSocketConnections, Log, OperationsPage.Html).ServeAsync,
            RosbridgeServer.CountFragmentsAsync);
    }

    /// <summary>With the port that was taken.</summary>
    public IPEndPoint SyncEndPoint => _sync.EndPoint;

    /// <inheritdoc cref="SyncEndPoint"/>
    public IPEndPoint WebSocketEndPoint { get; private set; }

    /// <summary>Where browsers find the control clock as a code for cameras, under each name; none where the page was not built.</summary>
    public IReadOnlyList<Uri> CodePageUris =>
        !_page.IsBuilt ? [] : [.. OwnHosts.Reachable(_options.Bind).Select(host => PageUri(host, CodePage.Path))];

    /// <summary>Where browsers find the page of operations, under each name; none where the page was not built.</summary>
    public IReadOnlyList<Uri> OperationsPageUris =>
        OperationsPage.Html == null ? [] : [.. OwnHosts.Reachable(_options.Bind).Select(host => PageUri(host, OperationsRoutes.Path))];

    /// <summary>Whether headsets are given tokens of their own.</summary>
    public bool PairsHeadsets => _options.Headsets != null;

    /// <summary>Where a browser on this machine finds the code that pairs a headset; null where it pairs none, or the page was not built.</summary>
    public Uri PairingPageUri => PairsHeadsets && _pairing.Page.IsBuilt ? PageUri(LocalHost, PairingLimits.Path) : null;

    /// <summary>Makes an adapter that this gateway starts a source.</summary>
    internal string AdapterToken => _options.AdapterToken;

    /// <summary>What headsets pin; null without TLS.</summary>
    public CertificatePin Pin => _options.Certificate == null ? null : CertificatePin.Of(_options.Certificate);

    /// <summary>When the certificate expires, or did, UTC; from then on headsets refuse it. Null without TLS.</summary>
    public DateTime? CertificateExpires => _options.CertificateExpires;

    /// <summary>What whoever runs it should know: rights it has for nothing, files that others can read.</summary>
    public IEnumerable<string> Warnings => Precautions.Of(_options, Environment.GetEnvironmentVariable("CREDENTIALS_DIRECTORY"));

    /// <summary>For those that belong to it: nobody fills the disk through it.</summary>
    internal Action<string> Log => _log.Write;

    internal EventList Events => _status.Events;

    internal TimeProvider Time => _options.Time;

    public MessageHub Hub { get; }

    /// <summary>Writes what passes the hub into files, when it is switched on.</summary>
    public Recorder Recorder { get; }

    internal RecordingsWatch RecordingsWatch { get; }

    /// <summary>C1 as headsets get it.</summary>
    public ServedClock Clock { get; }

    public PlantClocks PlantClocks { get; }

    /// <summary>Messages of clients that were dropped, and messages slow clients lost.</summary>
    internal DropCounters Drops => _rosbridge.Drops;

    public ConnectionCounters SyncConnections => _sync.Counters;
    public ConnectionCounters WebSocketConnections { get; }

    /// <summary>Connections of both ports that were not let in yet.</summary>
    internal int PendingCount => _sync.PendingCount + _webPending.Count;

    /// <summary>Connections that end with their token.</summary>
    internal int WatchedTokens => _access.Count;

    /// <summary>Starts both servers; they accept when this returns.</summary>
    /// <param name="clock">The gateway's own: what it serves until an adapter tells that of the control system.</param>
    /// <param name="log">Takes short lines without secrets, from any thread; null for none.</param>
    /// <exception cref="InputException">The options contradict the protocol.</exception>
    /// <exception cref="IOException">A port cannot be had: it is taken, or the address is not this machine's. Either may pass.</exception>
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
        _limits.Dispose();
        _comparison.Dispose();
        _access.Dispose();
        _rosbridge.Stop();
        _sync.Dispose();
        using var patience = new CancellationTokenSource(StopTimeout);
        await _web.StopAsync(patience.Token);
        await _web.DisposeAsync();
        _rosbridge.Dispose();
        // Last: what was received until now is to be in the file.
        await Recorder.DisposeAsync();
        _log.Dispose();
    }

    string LocalHost => _options.Bind.Equals(IPAddress.Any) || _options.Bind.Equals(IPAddress.IPv6Any)
        ? "localhost" : OwnHosts.Reachable(_options.Bind).First();

    Uri PageUri(string host, string path) =>
        new($"{(Pin == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps)}://{host}:{WebSocketEndPoint.Port}{path}");

    async Task StartWebAsync(CancellationToken cancellation)
    {
        try
        {
            await _web.StartAsync(cancellation);
        }
        catch (Exception e) when (e is IOException or SocketException)
        {
            throw PortListener.Refusal("--ws-port", _options.Bind, _options.WebSocketPort, e.GetBaseException());
        }

        var addresses = _web.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>();
        WebSocketEndPoint = new IPEndPoint(_options.Bind, new Uri(addresses.Addresses.First()).Port);
        _pairing.Page.SyncPort = SyncEndPoint.Port;
        _pairing.Page.WebSocketPort = WebSocketEndPoint.Port;
    }
}
