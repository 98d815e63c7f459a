using System;
using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A ws:// link, or a wss:// link with a certificate that the device's certificate store trusts.</summary>
    sealed class ClientWebSocketLink : SystemWebSocketLink
    {
        readonly ConnectionSettings _settings;

        public ClientWebSocketLink(ConnectionSettings settings, IHeadsetClock clock) : base(clock) => _settings = settings;

        protected override async Task<WebSocket> OpenSocketAsync(CancellationToken cancel)
        {
            var socket = new ClientWebSocket();
            socket.Options.KeepAliveInterval = ProtocolLimits.PingInterval;
            if (_settings.Token != null) socket.Options.SetRequestHeader("Authorization", "Bearer " + _settings.Token);
            try
            {
                await socket.ConnectAsync(_settings.WebSocketUri, cancel).ConfigureAwait(false);
                return socket;
            }
            catch (Exception failure)
            {
                socket.Dispose();
                if (failure is WebSocketException refused) throw GatewayRefusalException.OfHandshake(Reason(refused), refused);
                throw;
            }
        }

        static string Reason(WebSocketException failure) =>
            failure.InnerException == null ? failure.Message : failure.Message + " (" + failure.InnerException.Message + ")";
    }
}
