using System;
using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Puts the fragments of WebSocket messages together within the protocol's limits.</summary>
    /// <remarks>
    /// The library hands out bytes as they come and does not tell where a fragment ends; a piece smaller than any TCP
    /// segment is taken for one. Larger fragments are bounded by the length of a message.
    /// A message that is too long or in too many pieces is read to its end and dropped, so the connection goes on. One that
    /// does not come to its end in time, or is longer than sixteen times the longest allowed, ends the connection: nothing
    /// says where the next one begins.
    /// </remarks>
    sealed class TextMessageReader
    {
        const int ChunkBytes = 64 * 1024;

        /// <summary>RFC 879: no host is asked for smaller segments.</summary>
        const int LeastSegmentBytes = 536;

        const int LongestDiscarded = 16 * ProtocolLimits.DescriptionBytes;

        readonly WebSocket _socket;
        readonly IHeadsetClock _clock;
        readonly byte[] _chunk = new byte[ChunkBytes];
        byte[] _message = new byte[ChunkBytes];
        int _length;
        int _fragments;

        public TextMessageReader(WebSocket socket, IHeadsetClock clock)
        {
            _socket = socket;
            _clock = clock;
        }

        /// <summary>Hands over the messages, one after the other, until the connection is closed. Makes no garbage for one that comes in one piece.</summary>
        /// <param name="cancel">Ends the handing over with the next message; the socket is not told, for it would be aborted.</param>
        /// <exception cref="MessageLimitException">The message broke a limit that ends the connection.</exception>
        /// <exception cref="WebSocketException">The connection was lost.</exception>
        public async Task ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel)
        {
            while (true)
            {
                _length = _fragments = 0;
                var last = await _socket.ReceiveAsync(_chunk.AsMemory(), CancellationToken.None).ConfigureAwait(false);
                Append(last);
                if (!last.EndOfMessage) last = await RestAsync().ConfigureAwait(false);
                var arrival = _clock.Now;
                cancel.ThrowIfCancellationRequested();
                if (last.MessageType == WebSocketMessageType.Close) return;
                var dropped = Fault(last.MessageType);
                take(dropped == DropReason.None
                    ? ReceivedText.Message(_message.AsMemory(0, _length), arrival) : ReceivedText.Drop(dropped, arrival));
            }
        }

        async Task<ValueWebSocketReceiveResult> RestAsync()
        {
            using (var timeUp = new CancellationTokenSource(ProtocolLimits.MessageTimeout))
            {
                try
                {
                    while (true)
                    {
                        var next = await _socket.ReceiveAsync(_chunk.AsMemory(), timeUp.Token).ConfigureAwait(false);
                        Append(next);
                        if (next.EndOfMessage) return next;
                        if (_length > LongestDiscarded)
                            throw new MessageLimitException(
                                "a message of more than " + LongestDiscarded + " bytes", DropReason.TooLarge);
                    }
                }
                catch (Exception failure) when (timeUp.IsCancellationRequested)
                {
                    // Cancelled, the library aborts the connection and reports either that or the cancellation.
                    throw new MessageLimitException(
                        "a message that was not complete within " + ProtocolLimits.MessageTimeout.TotalSeconds + " s", DropReason.TooSlow, failure);
                }
            }
        }

        void Append(in ValueWebSocketReceiveResult piece)
        {
            if (piece.Count < LeastSegmentBytes) _fragments++;
            var before = _length;
            _length += piece.Count;
            if (_length > ProtocolLimits.DescriptionBytes) return;
            if (_length > _message.Length) Array.Resize(ref _message, Math.Min(2 * _length, ProtocolLimits.DescriptionBytes));
            Array.Copy(_chunk, 0, _message, before, piece.Count);
        }

        DropReason Fault(WebSocketMessageType type)
        {
            if (type != WebSocketMessageType.Text) return DropReason.NotJson;
            if (_length > ProtocolLimits.DescriptionBytes) return DropReason.TooLarge;
            return _fragments > ProtocolLimits.FragmentsPerMessage ? DropReason.TooManyFragments : DropReason.None;
        }
    }
}
