using Microsoft.AspNetCore.Http.Features;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Speaks rosbridge v2 on every path of the WebSocket port.</summary>
sealed class RosbridgeServer(GatewayOptions options, IControlClock clock, MessageHub hub, Action<string> log) : IDisposable
{
    readonly AccessRule _access = new(options);
    readonly CancellationTokenSource _stop = new();

    public ConnectionCounters Counters { get; } = new();
    public DropCounters Drops { get; } = new();

    /// <summary>Ends every connection.</summary>
    public void Stop() => _stop.Cancel();

    public void Dispose() => _stop.Dispose();

    /// <summary>Before the WebSocket middleware, which takes the upgrade that is there when it is called.</summary>
    public static Task CountFragmentsAsync(HttpContext context, RequestDelegate next)
    {
        if (context.Features.Get<IHttpUpgradeFeature>() is { } upgrade)
            context.Features.Set<IHttpUpgradeFeature>(new CountingUpgrade(upgrade));
        return next(context);
    }

    public async Task ServeAsync(HttpContext context)
    {
        if (!_access.IsOriginAllowed(context))
            await RefuseAsync(context, StatusCodes.Status403Forbidden, Closure.Origin, "the Origin is not the gateway's own");
        else if (_access.RoleOf(context) is not { } role)
            await RefuseAsync(context, StatusCodes.Status401Unauthorized, Closure.Token, "no or an unknown bearer token");
        else if (!context.WebSockets.IsWebSocketRequest)
            await AnswerAsync(context, StatusCodes.Status426UpgradeRequired, "this port speaks rosbridge v2 over WebSocket");
        else if (!Counters.TryEnter(options.MaxConnections))
            await AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, $"no more than {options.MaxConnections} connections");
        else
            await ServeAsync(context, role);
    }

    async Task ServeAsync(HttpContext context, Role role)
    {
        var why = Closure.ByPeer;
        try
        {
            why = await TalkAsync(context, role);
        }
        finally
        {
            Counters.Leave(why);
            if (why is not (Closure.ByPeer or Closure.Stopped))
                log($"websocket: closed a connection, {why}");
        }
    }

    async Task<Closure> TalkAsync(HttpContext context, Role role)
    {
        var fragments = ((CountingUpgrade)context.Features.Get<IHttpUpgradeFeature>()).Fragments;
        using var socket = await context.WebSockets.AcceptWebSocketAsync(new WebSocketAcceptContext
        {
            KeepAliveInterval = options.PingInterval,
            KeepAliveTimeout = options.PongTimeout,
        });
        var receiver = new MessageReceiver(socket, fragments, options, TimeProvider.System);
        using var connection = new RosbridgeConnection(socket, receiver, _stop.Token);
        using var session = new RosbridgeSession(hub, clock, role, Drops, options.QueueLength, connection.Reply, connection.Start);
        return await connection.RunAsync(session);
    }

    async Task RefuseAsync(HttpContext context, int status, Closure why, string text)
    {
        Counters.Count(why);
        log($"websocket: refused a connection, {why}");
        if (status == StatusCodes.Status401Unauthorized)
            context.Response.Headers.WWWAuthenticate = "Bearer";
        await AnswerAsync(context, status, text);
    }

    static Task AnswerAsync(HttpContext context, int status, string text)
    {
        context.Response.StatusCode = status;
        // Whoever is not let in must not hold one of the places that are.
        context.Response.Headers.Connection = "close";
        context.Response.ContentType = "text/plain; charset=utf-8";
        return context.Response.WriteAsync(text + "\n");
    }
}
