using System;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A link over .NET's <see cref="WebSocket"/> on a stream that this package opens: its own TLS check and HTTP upgrade.</summary>
    /// <remarks>
    /// Unity's WebSocket clients never call a validation callback, so they cannot check a pin. On Unity's class library, .NET's client never ends
    /// an attempt whose upgrade request gets no response, and does not report the status code of a refusal.
    /// </remarks>
    sealed class SystemWebSocketLink : IWebSocketLink
    {
        readonly Func<CancellationToken, Task<WebSocket>> _open;
        readonly IHeadsetClock _clock;
        WebSocket _socket;
        TextMessageReader _reader;

        public SystemWebSocketLink(ConnectionSettings settings, IHeadsetClock clock) : this(cancel => OpenSocketAsync(settings, cancel), clock) { }

        /// <param name="open">Opens the socket.</param>
        internal SystemWebSocketLink(Func<CancellationToken, Task<WebSocket>> open, IHeadsetClock clock) => (_open, _clock) = (open, clock);

        public async Task OpenAsync(CancellationToken cancel)
        {
            _socket = await _open(cancel).ConfigureAwait(false);
            _reader = new TextMessageReader(_socket, _clock);
        }

        public Task SendAsync(string text, CancellationToken cancel) => _socket.SendAsync(
            new ArraySegment<byte>(Encoding.UTF8.GetBytes(text)), WebSocketMessageType.Text, endOfMessage: true, cancel);

        public async Task<string> ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel)
        {
            // Cancels only the waiting, because cancelling the receive would abort the WebSocket and prevent an orderly close.
            await _reader.ReceiveAsync(take, cancel).OrCancelled(cancel).ConfigureAwait(false);
            // Repeats the received close code, or sends the code for a normal closure if none was received (RFC 6455, 5.5.1).
            await CloseOutputAsync(_socket.CloseStatus ?? WebSocketCloseStatus.NormalClosure).ConfigureAwait(false);
            return _socket.CloseStatusDescription;
        }

        /// <summary>
        /// Closes the connection in the background within a second, with a close frame, so that the server does not consider it lost.
        /// </summary>
        public void Dispose()
        {
            if (_socket != null) _ = CloseAsync(_socket);
        }

        static async Task<WebSocket> OpenSocketAsync(ConnectionSettings settings, CancellationToken cancel)
        {
            var stream = await new GatewayDialer(settings).OpenAsync(settings.WebSocketPort, cancel).ConfigureAwait(false);
            try
            {
                using (cancel.Register(stream.Dispose))
                    await WebSocketUpgrade.RequestAsync(stream, settings.WebSocketUri, settings.Token).ConfigureAwait(false);
                return WebSocket.CreateFromStream(stream, isServer: false, subProtocol: null, ProtocolLimits.PingInterval);
            }
            catch
            {
                stream.Dispose();
                cancel.ThrowIfCancellationRequested();
                throw;
            }
        }

        async Task CloseAsync(WebSocket socket)
        {
            if (socket.State == WebSocketState.Open) await CloseOutputAsync(WebSocketCloseStatus.NormalClosure).ConfigureAwait(false);
            socket.Dispose();
        }

        async Task CloseOutputAsync(WebSocketCloseStatus status)
        {
            using (var timeout = new CancellationTokenSource(ProtocolLimits.CloseTimeout))
            {
                try
                {
                    await _socket.CloseOutputAsync(status, null, timeout.Token).ConfigureAwait(false);
                }
                catch (Exception)
                {
                    // The socket is disposed in any case.
                }
            }
        }
    }
}
