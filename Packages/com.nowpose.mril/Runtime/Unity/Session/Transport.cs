using Nowpose.Network;

namespace Nowpose.Unity.Session
{
    /// <summary>Selects the WebSocket implementation: NativeWebSocket if this package is installed, otherwise the package's own link.</summary>
    static class Transport
    {
        /// <summary>Creates the WebSocket connection of a session.</summary>
        public static IWebSocketLink Create(ConnectionSettings settings, IHeadsetClock clock)
        {
#if NOWPOSE_NATIVE_WEBSOCKET
            // NativeWebSocket cannot check a pin, because it has no certificate callback.
            if (settings.Security != TransportSecurity.Pinned) return new NativeWebSocketLink(settings, clock);
#endif
            return WebSocketLinks.Create(settings, clock);
        }
    }
}
