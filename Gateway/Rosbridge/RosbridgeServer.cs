using Microsoft.AspNetCore.Http.Features;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Speaks rosbridge v2 on every path of the WebSocket port.</summary>
sealed class RosbridgeServer(
    GatewayOptions options, IControlClock clock, MessageHub hub, ConnectionCounters counters, Action<string> log) : IDisposable
{
    readonly Door _door = new(options, counters, log);
    readonly CancellationTokenSource _stop = new();

    public ConnectionCounters Counters => counters;
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
        if (await _door.AdmitAsync(context) is not { } role)
            return;
        if (!context.WebSockets.IsWebSocketRequest)
            await Door.AnswerAsync(context, StatusCodes.Status426UpgradeRequired, "this port speaks rosbridge v2 over WebSocket");
        else if (!counters.TryEnter(options.MaxConnections))
            await Door.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, $"no more than {options.MaxConnections} connections");
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
            counters.Leave(why);
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
}
