using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.AspNetCore.Server.Kestrel.Https;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Microsoft.Extensions.Options;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway;

/// <summary>Builds the gateway's HTTP server with its limits, TLS and request handlers.</summary>
static class GatewayWeb
{
    /// <summary>Maximum number of unsent bytes per connection. It holds a few samples.</summary>
    const int MaxUnsentBytes = 4096;

    /// <summary>Number of additional connections, for those that were evicted but are not closed yet.</summary>
    const int ClosingConnections = 16;

    static readonly TimeSpan AnswerGrace = TimeSpan.FromSeconds(5);

    /// <param name="pending">Limits the connections before authentication.</param>
    /// <param name="counters">Counters of the connections to the port.</param>
    /// <param name="log">Receives short lines without secrets, on any thread.</param>
    /// <param name="rosbridge">Serves WebSockets.</param>
    /// <param name="before">
    /// Handlers called before <paramref name="rosbridge"/>, in this order, but not for WebSocket requests. Each serves a request or calls the next
    /// handler.
    /// </param>
    public static WebApplication Build(
        GatewayOptions options, PendingWebConnections pending, ConnectionCounters counters, Action<string> log, RequestDelegate rosbridge,
        params Func<HttpContext, RequestDelegate, Task>[] before)
    {
        // Uses the empty builder, so that settings in the working folder or the environment do not change the gateway's behaviour.
        var builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.Services.AddSingleton<IHostLifetime, NoSignals>();
        builder.WebHost.UseKestrelCore().UseKestrelHttpsConfiguration();
        // Limits the unread bytes of each connection. MessageReceiver assembles longer messages, with its own limits.
        builder.Services.Configure<SocketTransportOptions>(sockets =>
        {
            sockets.MaxReadBufferSize = ProtocolLimits.MessageBytes;
            sockets.MaxWriteBufferSize = MaxUnsentBytes;
            sockets.CreateBoundListenSocket = _ => PortListener.Open("--ws-port", options.Bind, options.WebSocketPort).Server;
        });
        builder.WebHost.ConfigureKestrel(kestrel => Configure(kestrel, options, pending));
        builder.Services.AddSingleton<IConnectionListenerFactory>(
            services => new ResilientListenerFactory(services.GetRequiredService<IOptions<SocketTransportOptions>>(), counters, log));
        var web = builder.Build();
        web.Use(next => context => PendingWebConnections.CompleteHandshakeAsync(context, next));
        web.Use(next => context => SecurityHeaders.AddAsync(context, next));
        foreach (var serve in before)
            web.Use(next => context => context.Request.Headers.Upgrade.Count > 0 ? next(context) : serve(context, next));
        web.Use(next => context => RosbridgeServer.CountFragmentsAsync(context, next));
        web.UseWebSockets(new WebSocketOptions { KeepAliveInterval = Timeout.InfiniteTimeSpan });
        web.Run(rosbridge);
        return web;
    }

    static void Configure(KestrelServerOptions kestrel, GatewayOptions options, PendingWebConnections pending)
    {
        kestrel.AddServerHeader = false;
        // The first timeout starts with the first byte of a request; the second limits the time before that byte.
        kestrel.Limits.RequestHeadersTimeout = kestrel.Limits.KeepAliveTimeout = options.TokenTimeout;
        // Allows additional connections before authentication, so that a rejected client still receives a response.
        kestrel.Limits.MaxConcurrentConnections =
            (long)options.MaxConnections + GatewayOptions.ReservedConnections + options.MaxPendingInAll + ClosingConnections;
        // Applies to pages and other responses. For WebSockets, RosbridgeConnection handles slow readers.
        kestrel.Limits.MinResponseDataRate = new MinDataRate(options.AnswerBytesPerSecond, AnswerGrace);
        kestrel.Limits.MaxResponseBufferSize = MaxUnsentBytes;
        kestrel.Limits.MaxRequestBufferSize = ProtocolLimits.MessageBytes;
        kestrel.Limits.MaxRequestBodySize = ProtocolLimits.MessageBytes;
        kestrel.Listen(options.Bind, options.WebSocketPort, listen => Configure(listen, options, pending));
    }

    static void Configure(ListenOptions listen, GatewayOptions options, PendingWebConnections pending)
    {
        listen.Use(next => connection => pending.ServeAsync(connection, next));
        listen.Protocols = HttpProtocols.Http1;
        if (options.Certificate == null) return;
        listen.UseHttps(new TlsHandshakeCallbackOptions
        {
            // Called for each connection, so that a renewed certificate is used without a restart.
            OnConnection = _ => ValueTask.FromResult(options.ServerCertificate.ForConnection()),
            HandshakeTimeout = options.TokenTimeout,
        });
        listen.Use(next => connection => PendingWebConnections.CompleteHandshakeAsync(connection, next));
    }
}
