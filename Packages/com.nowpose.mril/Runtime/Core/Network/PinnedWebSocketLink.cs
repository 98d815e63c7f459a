using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>wss:// with a pinned certificate: our own TLS check and HTTP upgrade, then the library's WebSocket on top.</summary>
    /// <remarks>Unity's WebSocket clients never ask a validation callback, so a pin cannot be checked through them.</remarks>
    sealed class PinnedWebSocketLink : SystemWebSocketLink
    {
        readonly ConnectionSettings _settings;

        public PinnedWebSocketLink(ConnectionSettings settings, IHeadsetClock clock) : base(clock) => _settings = settings;

        protected override async Task<WebSocket> OpenSocketAsync(CancellationToken cancel)
        {
            var stream = await new GatewayDialer(_settings).OpenAsync(_settings.WebSocketPort, cancel).ConfigureAwait(false);
            try
            {
                using (cancel.Register(stream.Dispose))
                    await WebSocketUpgrade.RequestAsync(stream, _settings.WebSocketUri, _settings.Token).ConfigureAwait(false);
                return WebSocket.CreateFromStream(stream, isServer: false, subProtocol: null, ProtocolLimits.PingInterval);
            }
            catch
            {
                stream.Dispose();
                cancel.ThrowIfCancellationRequested();
                throw;
            }
        }
    }
}
