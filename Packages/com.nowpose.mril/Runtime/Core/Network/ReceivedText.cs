using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>What came over a WebSocket: a message with its moment of arrival, a message that had to be dropped, or the end.</summary>
    public readonly struct ReceivedText
    {
        ReceivedText(string text, DropReason dropped, HeadsetTime arrival)
        {
            Text = text;
            Dropped = dropped;
            Arrival = arrival;
        }

        /// <summary>The connection was closed in order.</summary>
        public static ReceivedText Closed => default;

        /// <summary>The message; null when it was dropped or the connection closed.</summary>
        public string Text { get; }

        /// <summary>Why there is no text; <see cref="DropReason.None"/> with a text or at the end.</summary>
        public DropReason Dropped { get; }

        /// <summary>When its last byte was read from the socket.</summary>
        public HeadsetTime Arrival { get; }

        public bool IsClosed => Text == null && Dropped == DropReason.None;

        public static ReceivedText Message(string text, HeadsetTime arrival) => new ReceivedText(text, DropReason.None, arrival);
        public static ReceivedText Drop(DropReason reason, HeadsetTime arrival) => new ReceivedText(null, reason, arrival);
    }
}
