using System;
using System.IO;
using System.Net.Sockets;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Network
{
    /// <summary>Connection to the sync server. Sends the token first, then makes one exchange at a time. Calls block; not thread-safe.</summary>
    sealed class SyncConnection
    {
        readonly Stream _stream;
        readonly IHeadsetClock _clock;
        readonly SyncFaultCounters _faults;
        readonly byte[] _request = new byte[SyncFrame.Size];
        readonly byte[] _reply = new byte[SyncFrame.Size];
        uint _sequence;

        public SyncConnection(Stream stream, IHeadsetClock clock, SyncFaultCounters faults) => (_stream, _clock, _faults) = (stream, clock, faults);

        /// <exception cref="GatewayRefusalException">The gateway rejects the token.</exception>
        public void ShowToken(string token)
        {
            var bytes = SyncToken.Write(token);
            _stream.Write(bytes, 0, bytes.Length);
            _stream.Flush();
            if (!Receive(SyncFrameKind.TokenReply).IsAccepted)
                throw GatewayRefusalException.OfToken(ConnectionMessages.TokenNotAccepted);
        }

        /// <summary>Sends a request and waits for its reply.</summary>
        /// <returns>The fault of the reply; the exchange is valid only with <see cref="SyncExchangeFault.None"/>.</returns>
        /// <exception cref="IOException">No reply arrived in time, the frame is invalid, or the connection was lost.</exception>
        public SyncExchangeFault Exchange(out SyncExchange exchange)
        {
            var sequence = ++_sequence;
            var t1 = _clock.Now;
            SyncFrame.Request(sequence, t1.Nanoseconds).Write(_request);
            _stream.Write(_request, 0, _request.Length);
            _stream.Flush();
            var reply = Receive(SyncFrameKind.Reply);
            var t4 = _clock.Now;

            exchange = SyncExchange.Of(t1, reply, t4);
            if (reply.Sequence != sequence) return SyncExchangeFault.WrongSequence;
            if (reply.T1Ns != t1.Nanoseconds) return SyncExchangeFault.WrongEcho;
            return SyncExchangeRules.CheckReply(exchange, reply);
        }

        GatewayRefusalException NotAFrame(string message)
        {
            _faults.Count(SyncExchangeFault.NotAFrame);
            return new GatewayRefusalException(message);
        }

        // The system's own text about a timeout names no remedy. Mono reports WouldBlock.
        int Read(int got)
        {
            try
            {
                return _stream.Read(_reply, got, _reply.Length - got);
            }
            catch (Exception late) when (
                late.GetBaseException() is SocketException { SocketErrorCode: SocketError.TimedOut or SocketError.WouldBlock })
            {
                throw new IOException(ConnectionMessages.NoResponse(ProtocolLimits.SyncReplyTimeout.TotalSeconds), late);
            }
        }

        SyncFrame Receive(SyncFrameKind kind)
        {
            var end = _clock.Now + ProtocolLimits.SyncReplyTimeout;
            for (var got = 0; got < _reply.Length;)
            {
                // Uses one deadline for the whole frame, so that single bytes at long intervals do not extend the timeout.
                var left = (end - _clock.Now).TotalMilliseconds;
                if (left <= 0) throw new IOException(ConnectionMessages.NoResponse(ProtocolLimits.SyncReplyTimeout.TotalSeconds));
                _stream.ReadTimeout = (int)Math.Ceiling(left);
                var read = Read(got);
                if (read == 0 && got > 0) throw NotAFrame(ConnectionMessages.NotASyncFrame(SyncFrameFault.WrongSize));
                if (read == 0) throw new EndOfStreamException(ConnectionMessages.Closed());
                got += read;
            }
            if (!SyncFrame.TryRead(_reply, out var frame, out var fault))
                throw NotAFrame(ConnectionMessages.NotASyncFrame(fault));
            if (frame.Kind != kind)
                throw NotAFrame(ConnectionMessages.OtherSyncFrame(frame.Kind, kind));
            return frame;
        }
    }
}
