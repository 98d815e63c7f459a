using Microsoft.AspNetCore.Http.Features;
using Microsoft.AspNetCore.Server.Kestrel.Core.Features;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Sync;

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

    /// <summary>Closes all connections.</summary>
    public void Stop() => _stop.Cancel();

    public void Dispose() => _stop.Dispose();

    /// <summary>
    /// Middleware that counts the fragments of messages. It must run before the WebSocket middleware, which uses the upgrade feature.
    /// </summary>
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
        else
            await ServeAsync(context, role);
    }

    // Refuses and counts a connection beyond the maximum.
    async Task ServeAsync(HttpContext context, Role role)
    {
        var max = options.MaxConnectionsFor(role);
        if (!counters.TryEnter(max))
        {
            await accessControl.RefuseExcessAsync(context, Closure.ConnectionLimit, LimitMessages.Connections(max));
            return;
        }

        var token = accessControl.TokenHashOf(context);
        using var place = access.Sources.TryEnter(token, role, context.Connection.RemoteIpAddress);
        if (place == null)
        {
            counters.Leave(Closure.SourceLimit);
            await accessControl.RefuseExcessAsync(context, Closure.SourceLimit, LimitMessages.ConnectionsOfSource(options.MaxConnectionsOfSource));
            return;
        }

        var why = Closure.ByPeer;
        try
        {
            why = await TalkAsync(context, role, token);
        }
        finally
        {
            counters.Leave(why);
            if (why is not (Closure.ByPeer or Closure.Stopped))
                accessControl.Log(context, RequestMessages.Closed(why), role, accessControl.TokenHashOf(context));
        }
    }

    async Task<Closure> TalkAsync(HttpContext context, Role role, byte[] token)
    {
        var upgrade = (CountingUpgrade)context.Features.Get<IHttpUpgradeFeature>();
        // Removes Kestrel's limit: RosbridgeConnection drops messages to slow readers, and disconnects those that are too slow.
        if (context.Features.Get<IHttpMinResponseDataRateFeature>() is { } rate)
            rate.MinDataRate = null;
        using var socket = await context.WebSockets.AcceptWebSocketAsync(new WebSocketAcceptContext
        {
            // Disables the pings of .NET, because ReaderProgress sends pings that also measure how much the client has read.
            KeepAliveInterval = Timeout.InfiniteTimeSpan,
        });
        PendingWebConnections.Release(context);
        var isSource = role == Role.Source;
        // Only a source may send long messages.
        var longest = isSource ? ProtocolLimits.DescriptionBytes : ProtocolLimits.MessageBytes;
        var perSecond = isSource ? options.SourceMessagesPerSecond : options.ObserverMessagesPerSecond;
        var receiver = new MessageReceiver(socket, upgrade.Fragments, options, longest, new RequestRate(perSecond, hub.Time), hub.Time);
        using var reader = new ReaderProgress(
            upgrade.PingAsync, options.PingInterval, options.PongTimeout, hub.Time,
            () => log(RequestMessages.NoPong(AddressOf(context.Connection), SendWindow.AssumedBytesPerSecond / 1000)));
        upgrade.Fragments.Pong = payload => reader.OnPong(payload.Span);
        SendBuffer.Limit(context);
        using var connection = new RosbridgeConnection(socket, receiver, reader, Drops, _stop.Token);
        using var session = new RosbridgeSession(
            hub, clock, plant, _names, role, Drops, options.QueueLength, connection.Reply, connection.Start)
        {
            Address = AddressOf(context.Connection),
            IsOwnAdapter = options.IsOwnAdapter(token),
            MaxMessagesPerSecond = perSecond,
        };
        using var watched = access.Watch(token, role, connection.End, accessControl.LoginOf(context));
        var why = await connection.RunAsync(session);
        if (why == Closure.MalformedFrame)
            await upgrade.DrainAsync(ProtocolLimits.CloseTimeout);
        return why;
    }

    static string AddressOf(ConnectionInfo connection)
    {
        if (connection.RemoteIpAddress is not { } address) return null;
        // Omits the port, which differs for each connection, so that the list of events shows a client that reconnects as the same source.
        return (address.IsIPv4MappedToIPv6 ? address.MapToIPv4() : address).ToString();
    }
}
