using System;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>What all links over <see cref="WebSocket"/> have in common; how it is opened is the difference.</summary>
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
            // A WebSocket whose receiving is cancelled is aborted, and could not be closed in order any more.
            await _reader.ReceiveAsync(take, cancel).OrCancelled(cancel).ConfigureAwait(false);
            // With the code that came, or with none where none came (RFC 6455, 5.5.1).
            await CloseOutputAsync(_socket.CloseStatus ?? WebSocketCloseStatus.NormalClosure).ConfigureAwait(false);
        }

        /// <summary>Closes in order, so that the server does not take the connection for a lost one; in the background and within a second.</summary>
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
            using (var patience = new CancellationTokenSource(ProtocolLimits.GoodbyeTimeout))
            {
                try
                {
                    await _socket.CloseOutputAsync(status, null, patience.Token).ConfigureAwait(false);
                }
                catch (Exception)
                {
                    // It ends one way or the other.
                }
            }
        }

        protected abstract Task<WebSocket> OpenSocketAsync(CancellationToken cancel);
    }
}
