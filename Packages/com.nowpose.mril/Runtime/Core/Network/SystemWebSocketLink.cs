using System;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;

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

        public Task<ReceivedText> ReceiveAsync(CancellationToken cancel) => _reader.ReceiveAsync(cancel);

        public void Dispose()
        {
            _socket?.Dispose();
            GC.SuppressFinalize(this);
        }

        protected abstract Task<WebSocket> OpenSocketAsync(CancellationToken cancel);
    }
}
