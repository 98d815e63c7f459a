using System.Security.Authentication;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway;

/// <summary>The gateway's HTTP server: its limits, its TLS, and who is asked for what comes in.</summary>
static class GatewayWeb
{
    static readonly TimeSpan AnswerGrace = TimeSpan.FromSeconds(5);

    /// <param name="connections">Of the server's port.</param>
    /// <param name="rosbridge">Serves WebSockets.</param>
    /// <param name="before">Asked before it, in this order; each serves a request or calls the next.</param>
    public static WebApplication Build(
        GatewayOptions options, ConnectionCounters connections, RequestDelegate rosbridge, params Func<HttpContext, RequestDelegate, Task>[] before)
    {
        var newcomers = new NewcomerPlaces(new Newcomers(options.MaxNewcomers), connections);
        // Empty: neither settings of the folder it is started in nor of the environment change what the gateway does.
        var builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.Services.AddSingleton<IHostLifetime, NoSignals>();
        builder.WebHost.UseKestrelCore().UseKestrelHttpsConfiguration();
        // What waits to be read, of each connection; a message that is longer is put together elsewhere, with limits of its own.
        builder.Services.Configure<SocketTransportOptions>(sockets => sockets.MaxReadBufferSize = ProtocolLimits.MessageBytes);
        builder.WebHost.ConfigureKestrel(kestrel => Configure(kestrel, options, newcomers));
        var web = builder.Build();
        foreach (var serve in before) web.Use(next => context => serve(context, next));
        web.UseWebSockets(new WebSocketOptions { KeepAliveInterval = options.PingInterval, KeepAliveTimeout = options.PongTimeout });
        web.Run(rosbridge);
        return web;
    }

    static void Configure(KestrelServerOptions kestrel, GatewayOptions options, NewcomerPlaces newcomers)
    {
        kestrel.AddServerHeader = false;
        // The one runs from a request's first byte, the other until then.
        kestrel.Limits.RequestHeadersTimeout = kestrel.Limits.KeepAliveTimeout = options.TokenTimeout;
        // Twice: one that is refused must still get its answer.
        kestrel.Limits.MaxConcurrentConnections = 2L * options.MaxConnections;
        // Of pages and other answers; a WebSocket that is slow to read is dealt with by its connection.
        kestrel.Limits.MinResponseDataRate = new MinDataRate(options.AnswerBytesPerSecond, AnswerGrace);
        kestrel.Limits.MaxRequestBufferSize = ProtocolLimits.MessageBytes;
        kestrel.Limits.MaxRequestBodySize = ProtocolLimits.MessageBytes;
        kestrel.Listen(options.Bind, options.WebSocketPort, listen => Configure(listen, options, newcomers));
    }

    static void Configure(ListenOptions listen, GatewayOptions options, NewcomerPlaces newcomers)
    {
        listen.Use(next => connection => newcomers.ServeAsync(connection, next));
        listen.Protocols = HttpProtocols.Http1;
        if (options.Certificate == null) return;
        listen.UseHttps(https =>
        {
            // Asked at each connection: a renewed one is shown without a restart.
            https.ServerCertificateSelector = (_, _) => options.Certificate;
            https.SslProtocols = SslProtocols.Tls12 | SslProtocols.Tls13;
            https.HandshakeTimeout = options.TokenTimeout;
        });
    }
}
