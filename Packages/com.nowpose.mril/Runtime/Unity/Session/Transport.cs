using Nowpose.Network;

namespace Nowpose.Unity.Session
{
    /// <summary>Chooses the link for the joint positions: NativeWebSocket if that package is installed, else .NET's own client.</summary>
    static class Transport
    {
        /// <summary>Creates the link of a session.</summary>
        public static IWebSocketLink Create(ConnectionSettings settings, IHeadsetClock clock)
        {
#if NOWPOSE_NATIVE_WEBSOCKET
            // NativeWebSocket has no certificate callback, so pinned connections use the link that checks the pin.
            if (settings.Security != TransportSecurity.Pinned) return new NativeWebSocketLink(settings, clock);
#endif
            return WebSocketLinks.Create(settings, clock);
        }
    }
}
