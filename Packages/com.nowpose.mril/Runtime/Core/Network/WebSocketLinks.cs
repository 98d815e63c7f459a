namespace Nowpose.Network
{
    /// <summary>Creates the WebSocket link for the connection settings.</summary>
    static class WebSocketLinks
    {
        public static IWebSocketLink Create(ConnectionSettings settings, IHeadsetClock clock)
        {
            if (settings.Security == TransportSecurity.Pinned) return new PinnedWebSocketLink(settings, clock);
            return new ClientWebSocketLink(settings, clock);
        }
    }
}
