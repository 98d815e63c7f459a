using System.Net;
using System.Security.Authentication;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Sync;
using Nowpose.Gateway.VisibleLight;
using Nowpose.Pairing;
using Nowpose.Protocol;
using Nowpose.Web;

namespace Nowpose.Gateway;

/// <summary>The middleware between control system and headsets: clock sync over TCP, rosbridge v2 over WebSocket, and the hub between.</summary>
public sealed class GatewayServer : IAsyncDisposable
{
    static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(3);

    readonly SyncServer _sync;
    readonly RosbridgeServer _rosbridge;
    readonly CodePage _page;
    readonly PairingRoutes _pairing;
    readonly WebApplication _web;
    readonly IPAddress _bind;

    GatewayServer(
        GatewayOptions options, SyncServer sync, RosbridgeServer rosbridge, CodePage page, PairingRoutes pairing, MessageHub hub,
        WebApplication web)
    {
        _page = page;
        _pairing = pairing;
        PairsHeadsets = options.Headsets != null;
        _sync = sync;
        _rosbridge = rosbridge;
        _web = web;
        _bind = options.Bind;
        Hub = hub;
        Pin = options.Certificate == null ? null : CertificatePin.Of(options.Certificate);
    }

    /// <summary>With the port that was taken.</summary>
    public IPEndPoint SyncEndPoint => _sync.EndPoint;

    /// <inheritdoc cref="SyncEndPoint"/>
    public IPEndPoint WebSocketEndPoint { get; private set; }

    /// <summary>Where browsers find the control clock as a code for cameras, under each name; none where the page was not built.</summary>
    public IReadOnlyList<Uri> CodePageUris => !_page.IsBuilt ? [] : [.. OwnHosts.Reachable(_bind).Select(host => PageUri(host, CodePage.Path))];

    /// <summary>Whether headsets are given tokens of their own.</summary>
    public bool PairsHeadsets { get; }

    /// <summary>Where a browser on this machine finds the code that pairs a headset; null where it pairs none, or the page was not built.</summary>
    public Uri PairingPageUri => PairsHeadsets && _pairing.Page.IsBuilt ? PageUri(LocalHost, PairingLimits.Path) : null;

    /// <summary>What headsets pin; null without TLS.</summary>
    public CertificatePin Pin { get; }

    public MessageHub Hub { get; }

    /// <summary>Messages of clients that were dropped, and messages slow clients lost.</summary>
    public DropCounters Drops => _rosbridge.Drops;

    public ConnectionCounters SyncConnections => _sync.Counters;
    public ConnectionCounters WebSocketConnections => _rosbridge.Counters;

    /// <summary>Starts both servers; they accept when this returns.</summary>
    /// <param name="log">Takes short lines without secrets, from any thread; null for none.</param>
    /// <exception cref="InputException">The options contradict the protocol, or a port cannot be had.</exception>
    public static async Task<GatewayServer> StartAsync(
        GatewayOptions options, IControlClock clock, Action<string> log = null, CancellationToken cancellation = default)
    {
        options.Check();
        log ??= _ => { };
        var hub = new MessageHub();
        var connections = new ConnectionCounters();
        var rosbridge = new RosbridgeServer(options, clock, hub, connections, log);
        var page = new CodePage(options, clock, connections, log, LightCodePage.Html);
        var pairing = new PairingRoutes(options, connections, log, Web.PairingPage.Html);
        var sync = new SyncServer(options, clock, log);
        var server = new GatewayServer(options, sync, rosbridge, page, pairing, hub, Build(options, rosbridge, page, pairing));
        try
        {
            await server.StartWebAsync(options, cancellation);
            return server;
        }
        catch
        {
            await server.DisposeAsync();
            throw;
        }
    }

    public async ValueTask DisposeAsync()
    {
        _rosbridge.Stop();
        _sync.Dispose();
        using var patience = new CancellationTokenSource(StopTimeout);
        await _web.StopAsync(patience.Token);
        await _web.DisposeAsync();
        _rosbridge.Dispose();
    }

    string LocalHost => _bind.Equals(IPAddress.Any) || _bind.Equals(IPAddress.IPv6Any) ? "localhost" : OwnHosts.Reachable(_bind).First();

    Uri PageUri(string host, string path) =>
        new($"{(Pin == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps)}://{host}:{WebSocketEndPoint.Port}{path}");

    async Task StartWebAsync(GatewayOptions options, CancellationToken cancellation)
    {
        try
        {
            await _web.StartAsync(cancellation);
        }
        catch (IOException e)
        {
            throw new InputException($"--ws-port {options.WebSocketPort} on {options.Bind}: {(e.InnerException ?? e).Message}", e);
        }

        var addresses = _web.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>();
        WebSocketEndPoint = new IPEndPoint(_bind, new Uri(addresses.Addresses.First()).Port);
        _pairing.Page.SyncPort = SyncEndPoint.Port;
        _pairing.Page.WebSocketPort = WebSocketEndPoint.Port;
    }

    static WebApplication Build(GatewayOptions options, RosbridgeServer rosbridge, CodePage page, PairingRoutes pairing)
    {
        // Empty: neither settings of the folder it is started in nor of the environment change what the gateway does.
        var builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.Services.AddSingleton<IHostLifetime, NoSignals>();
        builder.WebHost.UseKestrelCore().UseKestrelHttpsConfiguration();
        builder.WebHost.ConfigureKestrel(kestrel => Configure(kestrel, options));
        var web = builder.Build();
        web.Use(next => context => page.ServeAsync(context, next));
        web.Use(next => context => pairing.ServeAsync(context, next));
        web.Use(next => context => RosbridgeServer.CountFragmentsAsync(context, next));
        web.UseWebSockets(new WebSocketOptions { KeepAliveInterval = options.PingInterval, KeepAliveTimeout = options.PongTimeout });
        web.Run(rosbridge.ServeAsync);
        return web;
    }

    static void Configure(KestrelServerOptions kestrel, GatewayOptions options)
    {
        kestrel.AddServerHeader = false;
        // The one runs from a request's first byte, the other until then.
        kestrel.Limits.RequestHeadersTimeout = kestrel.Limits.KeepAliveTimeout = options.TokenTimeout;
        // Twice: one that is refused must still get its answer.
        kestrel.Limits.MaxConcurrentConnections = 2L * options.MaxConnections;
        // A slow reader is dealt with by its queue and the pong that does not come.
        kestrel.Limits.MinResponseDataRate = null;
        kestrel.Listen(options.Bind, options.WebSocketPort, listen => Configure(listen, options));
    }

    static void Configure(ListenOptions listen, GatewayOptions options)
    {
        listen.Protocols = HttpProtocols.Http1;
        if (options.Certificate != null)
        {
            listen.UseHttps(https =>
            {
                https.ServerCertificate = options.Certificate;
                https.SslProtocols = SslProtocols.Tls12 | SslProtocols.Tls13;
                https.HandshakeTimeout = options.TokenTimeout;
            });
        }
    }
}
