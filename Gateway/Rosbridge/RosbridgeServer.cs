using Microsoft.AspNetCore.Http.Features;
using Microsoft.AspNetCore.Server.Kestrel.Core.Features;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Sync;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Serves rosbridge v2 on every path of the WebSocket port.</summary>
sealed class RosbridgeServer(
    GatewayOptions options, ServedClock clock, PlantClocks plant, MessageHub hub, AccessControl accessControl, AccessWatch access, ConnectionCounters counters,
    Action<string> log)
    : IDisposable
{
    readonly CancellationTokenSource _stop = new();
    readonly NamesInUse _names = new(options.Time);

    public DropCounters Drops { get; } = new();

    /// <summary>Ends every connection.</summary>
    public void Stop() => _stop.Cancel();

    public void Dispose() => _stop.Dispose();

    /// <summary>Middleware that must run before the WebSocket middleware, which uses the upgrade feature present when it is called.</summary>
    public static Task CountFragmentsAsync(HttpContext context, RequestDelegate next)
    {
        if (context.Features.Get<IHttpUpgradeFeature>() is { } upgrade)
            context.Features.Set<IHttpUpgradeFeature>(new CountingUpgrade(upgrade));
        return next(context);
    }

    public async Task ServeAsync(HttpContext context)
    {
        if (await accessControl.AdmitAsync(context) is not { } role)
            return;
        if (!context.WebSockets.IsWebSocketRequest)
            await AccessControl.AnswerAsync(
                context, StatusCodes.Status426UpgradeRequired, RequestMessages.NotAWebSocket);
        else if (!counters.TryEnter(options.MaxConnections))
            await AccessControl.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, LimitMessages.Connections(options.MaxConnections));
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
                log(RequestMessages.Closed(why));
        }
    }

    async Task<Closure> TalkAsync(HttpContext context, Role role)
    {
        var upgrade = (CountingUpgrade)context.Features.Get<IHttpUpgradeFeature>();
        // Slow readers lose messages; the connection itself detects those that are too slow.
        if (context.Features.Get<IHttpMinResponseDataRateFeature>() is { } rate)
            rate.MinDataRate = null;
        using var socket = await context.WebSockets.AcceptWebSocketAsync(new WebSocketAcceptContext
        {
            // The connection sends its own pings, which also measure how far the client has read.
            KeepAliveInterval = Timeout.InfiniteTimeSpan,
        });
        PendingPlaces.Release(context);
        var isSource = role == Role.Source;
        // Only a source may send long messages.
        var longest = isSource ? ProtocolLimits.DescriptionBytes : ProtocolLimits.MessageBytes;
        var allowed = new RequestRate(isSource ? options.SourceMessagesPerSecond : options.ObserverMessagesPerSecond);
        var receiver = new MessageReceiver(socket, upgrade.Fragments, options, longest, allowed, TimeProvider.System);
        using var reader = new ReaderProgress(
            upgrade.PingAsync, options.PingInterval, options.PongTimeout, TimeProvider.System,
            () => log(RequestMessages.NoPong(AddressOf(context.Connection), SendWindow.AssumedBytesPerSecond / 1000)));
        upgrade.Fragments.Pong = payload => reader.OnPong(payload.Span);
        upgrade.Received = reader.OnReceived;
        SendBuffer.Limit(context);
        using var connection = new RosbridgeConnection(socket, receiver, reader, Drops, _stop.Token);
        using var session = new RosbridgeSession(
            hub, clock, plant, _names, role, Drops, options.QueueLength, connection.Reply, connection.Start)
        {
            Address = AddressOf(context.Connection),
        };
        using var watched = access.Watch(
            accessControl.TokenHashOf(context), role, () => connection.End(Closure.Token), accessControl.LoginOf(context));
        var why = await connection.RunAsync(session);
        if (why == Closure.MalformedFrame)
            await upgrade.DrainAsync(ProtocolLimits.CloseTimeout);
        return why;
    }

    static string AddressOf(ConnectionInfo connection)
    {
        if (connection.RemoteIpAddress is not { } address) return null;
        // Omits the port, which changes with each connection, so that a client that reconnects is the same source in the list of events.
        return (address.IsIPv4MappedToIPv6 ? address.MapToIPv4() : address).ToString();
    }
}
