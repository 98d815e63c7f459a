using Nowpose.Network;

namespace Nowpose.Unity.Session
{
    /// <summary>Chooses what carries the joint positions: NativeWebSocket where that package is installed, else .NET's own client.</summary>
    static class Transport
    {
        /// <summary>As a session asks for it.</summary>
        public static IWebSocketLink Create(ConnectionSettings settings, IHeadsetClock clock)
        {
#if NOWPOSE_NATIVE_WEBSOCKET
            // It asks nobody about a certificate, so a pin stays with the link that checks it.
            if (settings.Security != TransportSecurity.Pinned) return new NativeWebSocketLink(settings, clock);
#endif
            return WebSocketLinks.Create(settings, clock);
        }
    }
}
