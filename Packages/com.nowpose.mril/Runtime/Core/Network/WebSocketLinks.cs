namespace Nowpose.Network
{
    /// <summary>Chooses how to open the WebSocket.</summary>
    static class WebSocketLinks
    {
        public static IWebSocketLink Create(ConnectionSettings settings, IHeadsetClock clock)
        {
            if (settings.Security == TransportSecurity.Pinned) return new PinnedWebSocketLink(settings, clock);
            return new ClientWebSocketLink(settings, clock);
        }
    }
}
