using System;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A message received over a WebSocket with its arrival time, or the reason why it was dropped.</summary>
    readonly struct ReceivedText
    {
        ReceivedText(ReadOnlyMemory<byte> utf8, DropReason dropped, HeadsetTime arrival) => (Utf8, Dropped, Arrival) = (utf8, dropped, arrival);

        /// <summary>The message as received. Valid only during the callback, because the next message uses the same memory.</summary>
        public ReadOnlyMemory<byte> Utf8 { get; }

        /// <summary>Reason why the message was dropped; <see cref="DropReason.None"/> if it was not dropped.</summary>
        public DropReason Dropped { get; }

        /// <summary>Time at which the last byte of the message was read from the socket.</summary>
        public HeadsetTime Arrival { get; }

        public static ReceivedText Message(ReadOnlyMemory<byte> utf8, HeadsetTime arrival) => new ReceivedText(utf8, DropReason.None, arrival);
        public static ReceivedText Drop(DropReason reason, HeadsetTime arrival) => new ReceivedText(default, reason, arrival);
    }
}
