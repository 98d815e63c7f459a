using System.Security.Authentication;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Microsoft.Extensions.Options;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway;

/// <summary>The gateway's HTTP server: its limits, its TLS, and who is asked for what comes in.</summary>
static class GatewayWeb
{
    /// <summary>Bytes of a connection that may wait to be sent: a few samples.</summary>
    const int MaxUnsentBytes = 4096;

    /// <summary>Connections that have been evicted and are not closed yet.</summary>
    const int ClosingConnections = 16;

    static readonly TimeSpan AnswerGrace = TimeSpan.FromSeconds(5);

    /// <param name="pending">Places of connections that were not let in yet.</param>
    /// <param name="log">Takes short lines without secrets, from any thread.</param>
    /// <param name="rosbridge">Serves WebSockets.</param>
    /// <param name="before">Asked before it, in this order; each serves a request or calls the next.</param>
    public static WebApplication Build(
        GatewayOptions options, PendingPlaces pending, Action<string> log, RequestDelegate rosbridge,
        params Func<HttpContext, RequestDelegate, Task>[] before)
    {
        // Empty: neither settings of the folder it is started in nor of the environment change what the gateway does.
        var builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.Services.AddSingleton<IHostLifetime, NoSignals>();
        builder.WebHost.UseKestrelCore().UseKestrelHttpsConfiguration();
        // What waits to be read, of each connection; a message that is longer is put together elsewhere, with limits of its own.
        builder.Services.Configure<SocketTransportOptions>(sockets =>
        {
            sockets.MaxReadBufferSize = ProtocolLimits.MessageBytes;
            sockets.MaxWriteBufferSize = MaxUnsentBytes;
        });
        builder.WebHost.ConfigureKestrel(kestrel => Configure(kestrel, options, pending));
        builder.Services.AddSingleton<IConnectionListenerFactory>(
            services => new PatientListenerFactory(services.GetRequiredService<IOptions<SocketTransportOptions>>(), log));
        var web = builder.Build();
        web.Use(next => context => PendingPlaces.CompleteHandshakeAsync(context, next));
        web.Use(next => context => SecurityHeaders.AddAsync(context, next));
        foreach (var serve in before) web.Use(next => context => serve(context, next));
        web.UseWebSockets(new WebSocketOptions { KeepAliveInterval = Timeout.InfiniteTimeSpan });
        web.Run(rosbridge);
        return web;
    }

    static void Configure(KestrelServerOptions kestrel, GatewayOptions options, PendingPlaces pending)
    {
        kestrel.AddServerHeader = false;
        // The one runs from a request's first byte, the other until then.
        kestrel.Limits.RequestHeadersTimeout = kestrel.Limits.KeepAliveTimeout = options.TokenTimeout;
        // Connections that have not been let in yet have places besides: one that is refused must still get its answer.
        kestrel.Limits.MaxConcurrentConnections = (long)options.MaxConnections + options.MaxPendingInAll + ClosingConnections;
        // Of pages and other answers; a WebSocket that is slow to read is dealt with by its connection.
        kestrel.Limits.MinResponseDataRate = new MinDataRate(options.AnswerBytesPerSecond, AnswerGrace);
        kestrel.Limits.MaxResponseBufferSize = MaxUnsentBytes;
        kestrel.Limits.MaxRequestBufferSize = ProtocolLimits.MessageBytes;
        kestrel.Limits.MaxRequestBodySize = ProtocolLimits.MessageBytes;
        kestrel.Listen(options.Bind, options.WebSocketPort, listen => Configure(listen, options, pending));
    }

    static void Configure(ListenOptions listen, GatewayOptions options, PendingPlaces pending)
    {
        listen.Use(next => connection => pending.ServeAsync(connection, next));
        listen.Protocols = HttpProtocols.Http1;
        if (options.Certificate == null) return;
        listen.UseHttps(https =>
        {
            // Asked at each connection: a renewed one is shown without a restart.
            https.ServerCertificateSelector = (_, _) => options.Certificate;
            https.SslProtocols = SslProtocols.Tls12 | SslProtocols.Tls13;
            https.HandshakeTimeout = options.TokenTimeout;
        });
        listen.Use(next => connection => PendingPlaces.CompleteHandshakeAsync(connection, next));
    }
}
