using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Connections.Features;

namespace Nowpose.Gateway.Security;

/// <summary>Counts each TCP connection to the web server as pending, from its start, before TLS, until it is authenticated.</summary>
sealed class PendingWebConnections(PendingConnections pending, ConnectionCounters counters, Action<string> log)
{
    static readonly object Key = new();

    /// <summary>Records that a connection is authenticated, because its request was admitted.</summary>
    public static void Release(HttpContext context) => Of(context.Features.Get<IConnectionItemsFeature>()?.Items)?.Dispose();

    /// <summary>Records that a connection has sent a complete request.</summary>
    public static Task CompleteHandshakeAsync(HttpContext context, RequestDelegate next)
    {
        Of(context.Features.Get<IConnectionItemsFeature>()?.Items)?.CompleteHandshake();
        return next(context);
    }

    /// <summary>Records that the TLS handshake of a connection is complete.</summary>
    public static Task CompleteHandshakeAsync(ConnectionContext connection, ConnectionDelegate next)
    {
        Of(connection.Items)?.CompleteHandshake();
        return next(connection);
    }

    public async Task ServeAsync(ConnectionContext connection, ConnectionDelegate next)
    {
        using var place = pending.Enter(connection.RemoteEndPoint, () => Evict(connection));
        connection.Items[Key] = place;
        await next(connection);
    }

    void Evict(ConnectionContext connection)
    {
        counters.Count(Closure.ConnectionLimit);
        log(AccessMessages.ClosedForNewer);
        connection.Abort();
    }

    static PendingConnection Of(IDictionary<object, object> items) => items != null && items.TryGetValue(Key, out var place) ? place as PendingConnection : null;
}
