using System;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>What all links over <see cref="WebSocket"/> have in common; how it is opened is the difference.</summary>
    public abstract class SystemWebSocketLink : IWebSocketLink
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

        public async Task<ReceivedText> ReceiveAsync(CancellationToken cancel)
        {
            var received = await _reader.ReceiveAsync(cancel).ConfigureAwait(false);
            if (received.IsClosed) await AnswerCloseAsync().ConfigureAwait(false);
            return received;
        }

        public void Dispose()
        {
            _socket?.Dispose();
            GC.SuppressFinalize(this);
        }

        // With the code that came, or with none where none came (RFC 6455, 5.5.1); the server may be gone without waiting for it.
        async Task AnswerCloseAsync()
        {
            using (var patience = new CancellationTokenSource(ProtocolLimits.GoodbyeTimeout))
            {
                try
                {
                    var status = _socket.CloseStatus ?? WebSocketCloseStatus.NormalClosure;
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
