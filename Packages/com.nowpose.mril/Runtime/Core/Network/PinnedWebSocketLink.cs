using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A wss:// link with a pinned certificate: its own TLS check and HTTP upgrade, then .NET's WebSocket on the stream.</summary>
    /// <remarks>Unity's WebSocket clients never call a validation callback, so they cannot check a pin.</remarks>
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
