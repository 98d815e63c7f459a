using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Connections.Features;

namespace Nowpose.Gateway.Security;

/// <summary>Takes a newcomer's place for each TCP connection of the web server, before TLS, and gives it back once a WebSocket was let in.</summary>
sealed class NewcomerPlaces(Newcomers newcomers, ConnectionCounters counters)
{
    static readonly object Key = new();

    /// <summary>Of a request that was let in.</summary>
    public static void GiveBack(HttpContext context) =>
        (context.Features.Get<IConnectionItemsFeature>()?.Items.TryGetValue(Key, out var place) == true ? place as IDisposable : null)?.Dispose();

    public async Task ServeAsync(ConnectionContext connection, ConnectionDelegate next)
    {
        using var place = newcomers.TryEnter(connection.RemoteEndPoint);
        if (place == null)
        {
            counters.Count(Closure.ConnectionLimit);
            connection.Abort();
            return;
        }

        connection.Items[Key] = place;
        await next(connection);
    }
}
