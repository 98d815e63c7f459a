using System;
using System.IO;
using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Assembles the fragments of WebSocket messages within the protocol's limits.</summary>
    /// <remarks>
    /// The library returns bytes as they arrive and does not report where a fragment ends, so a piece smaller than a TCP segment counts as
    /// a fragment. The maximum length of a message limits the number of larger pieces.
    /// A message that is too long or has too many pieces is read to its end and dropped, and the connection continues. A message that
    /// is not complete in time, or is longer than sixteen times the maximum length, ends the connection, because the start of the
    /// next message is unknown.
    /// </remarks>
    sealed class TextMessageReader
    {
        const int ChunkBytes = 64 * 1024;

        /// <summary>Minimum TCP segment size in bytes (RFC 879).</summary>
        const int MinSegmentBytes = 536;

        const int MaxDiscardedBytes = 16 * ProtocolLimits.DescriptionBytes;

        readonly WebSocket _socket;
        readonly IHeadsetClock _clock;
        readonly byte[] _chunk = new byte[ChunkBytes];
        byte[] _message = new byte[ChunkBytes];
        int _length;
        int _fragments;

        public TextMessageReader(WebSocket socket, IHeadsetClock clock) => (_socket, _clock) = (socket, clock);

        /// <summary>
        /// Passes the messages to a callback, in order, until the connection is closed. Allocates nothing for a message that arrives in a single
        /// read.
        /// </summary>
        /// <param name="cancel">
        /// Stops the method at the next message. The token is not passed to the socket, because cancelling a read aborts the connection.
        /// </param>
        /// <exception cref="MessageLimitException">A message exceeded a limit that ends the connection.</exception>
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
                        if (_length > MaxDiscardedBytes)
                            throw new MessageLimitException(ConnectionMessages.MessageTooLong(MaxDiscardedBytes), DropReason.TooLarge);
                    }
                }
                catch (Exception failure) when (timeUp.IsCancellationRequested)
                {
                    // On cancellation, the library aborts the connection and reports either the abort or the cancellation.
                    throw new MessageLimitException(
                        ConnectionMessages.MessageTooSlow(ProtocolLimits.MessageTimeout.TotalSeconds), DropReason.TooSlow, failure);
                }
            }
        }

        void Append(in ValueWebSocketReceiveResult piece)
        {
            if (piece.Count < MinSegmentBytes) _fragments++;
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

    /// <summary>Thrown when a message exceeds a limit, so that the start of the next message is unknown. The connection must end.</summary>
    sealed class MessageLimitException : IOException
    {
        public MessageLimitException(string message, DropReason reason, System.Exception innerException = null)
            : base(message, innerException) => Reason = reason;

        /// <summary>Drop reason under which the message is counted.</summary>
        public DropReason Reason { get; }
    }
}
