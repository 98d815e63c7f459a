using System;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A message that came over a WebSocket, with its moment of arrival; or why it was dropped.</summary>
    readonly struct ReceivedText
    {
        ReceivedText(ReadOnlyMemory<byte> utf8, DropReason dropped, HeadsetTime arrival)
        {
            Utf8 = utf8;
            Dropped = dropped;
            Arrival = arrival;
        }

        /// <summary>The message as it was received. Valid only during the call: the next message is read into the same memory.</summary>
        public ReadOnlyMemory<byte> Utf8 { get; }

        /// <summary>Why the message was dropped; <see cref="DropReason.None"/> when it was not.</summary>
        public DropReason Dropped { get; }

        /// <summary>When its last byte was read from the socket.</summary>
        public HeadsetTime Arrival { get; }

        public static ReceivedText Message(ReadOnlyMemory<byte> utf8, HeadsetTime arrival) => new ReceivedText(utf8, DropReason.None, arrival);
        public static ReceivedText Drop(DropReason reason, HeadsetTime arrival) => new ReceivedText(default, reason, arrival);
    }
}
