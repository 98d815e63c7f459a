using System;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Common base of the links over <see cref="WebSocket"/>; derived classes open the socket.</summary>
    abstract class SystemWebSocketLink : IWebSocketLink
    {
        readonly IHeadsetClock _clock;
        WebSocket _socket;
        TextMessageReader _reader;

        protected SystemWebSocketLink(IHeadsetClock clock) => _clock = clock;

        public async Task OpenAsync(CancellationToken cancel)
        {
            _socket = await OpenSocketAsync(cancel).ConfigureAwait(false);
            _reader = new TextMessageReader(_socket, _clock);
        }

        public Task SendAsync(string text, CancellationToken cancel) => _socket.SendAsync(
            new ArraySegment<byte>(Encoding.UTF8.GetBytes(text)), WebSocketMessageType.Text, endOfMessage: true, cancel);

        public async Task ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel)
        {
            // Cancels only the waiting, because cancelling the receive would abort the WebSocket and prevent an orderly close.
            await _reader.ReceiveAsync(take, cancel).OrCancelled(cancel).ConfigureAwait(false);
            // Repeats the received close code, or sends the code for a normal closure if none was received (RFC 6455, 5.5.1).
            await CloseOutputAsync(_socket.CloseStatus ?? WebSocketCloseStatus.NormalClosure).ConfigureAwait(false);
        }

        /// <summary>
        /// Closes the connection in the background within a second, with a close frame, so that the server does not consider it lost.
        /// </summary>
        public void Dispose()
        {
            if (_socket != null) _ = CloseAsync(_socket);
            GC.SuppressFinalize(this);
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

        protected abstract Task<WebSocket> OpenSocketAsync(CancellationToken cancel);
    }
}
