using Microsoft.AspNetCore.Connections.Features;
using Microsoft.AspNetCore.Http.Features;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Sync;

namespace Nowpose.Gateway.Codes;

/// <summary>Limits time requests over HTTP. Each connection counts as a WebSocket connection and has the rate limit of sync requests.</summary>
/// <remarks>Connections stay open between requests, because the time to connect again would be measured as network latency.</remarks>
sealed class TimeRequestLimits(GatewayOptions options, AccessControl accessControl, ConnectionCounters counters)
{
    /// <summary>Checks whether a request may be served. Otherwise, rejects it and ends its connection.</summary>
    /// <returns>True if the request may be served.</returns>
    public async Task<bool> AdmitAsync(HttpContext context, Role role)
    {
        var max = options.MaxConnectionsFor(role);
        if (PlaceOf(context, max) is not { } place)
            await accessControl.RefuseExcessAsync(context, Closure.ConnectionLimit, LimitMessages.Connections(max));
        else if (place.Rate.TryTake())
            return true;
        else
            await RefuseRateAsync(context, place);
        return false;
    }

    Task RefuseRateAsync(HttpContext context, Place place)
    {
        place.Why = Closure.TooManyRequests;
        accessControl.Log(context, RequestMessages.Closed(place.Why));
        return AccessControl.RefuseForNowAsync(context, TimeSpan.FromSeconds(1), LimitMessages.Requests(options.SyncRequestsPerSecond));
    }

    // Not locked, because the requests of one connection are sequential.
    Place PlaceOf(HttpContext context, int max)
    {
        var items = context.Features.GetRequiredFeature<IConnectionItemsFeature>().Items;
        if (items.TryGetValue(this, out var known)) return (Place)known;
        if (!counters.TryEnter(max)) return null;
        var place = new Place(new RequestRate(options.SyncRequestsPerSecond));
        items.Add(this, place);
        PendingWebConnections.Release(context);
        context.Features.GetRequiredFeature<IConnectionLifetimeFeature>().ConnectionClosed.Register(() => counters.Leave(place.Why));
        return place;
    }

    sealed class Place(RequestRate rate)
    {
        public RequestRate Rate => rate;
        public Closure Why { get; set; } = Closure.ByPeer;
    }
}
