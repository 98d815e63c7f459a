using System;

namespace Nowpose.Simulation
{
    /// <summary>One direction of a TCP connection over a packet link: nothing is lost, but what is lost on the link comes late and delays all behind it.</summary>
    /// <remarks>
    /// Retransmissions follow RFC 6298 with Linux's minimum: the first after the round-trip time and 200 ms, each further one
    /// after twice the time. In a stream of messages the first comes earlier, by RFC 8985: the selective acknowledgement of the
    /// next message shows the loss. Seeded, not thread-safe.
    /// </remarks>
    sealed class TcpStream
    {
        static readonly TimeSpan MinTimeout = TimeSpan.FromMilliseconds(200);

        readonly PacketLink _link;
        readonly TimeSpan _timeout, _lossSeen;
        HeadsetTime _newestArrival;

        /// <param name="start">Stalls of the link are counted from it.</param>
        /// <param name="interval">Time from one message to the next; null where each waits for an answer first.</param>
        public TcpStream(LinkProfile profile, HeadsetTime start, int seed, TimeSpan? interval = null)
        {
            // Each packet meets its own delay: the stream itself sees to the order.
            _link = new PacketLink(profile, start, seed, keepsOrder: false);
            var roundTrip = ClockTicks.Span(2 * (profile.BaseMs + profile.MeanJitterMs) / 1000);
            _timeout = MinTimeout + roundTrip;
            // RFC 8985 waits for a quarter of the round trip more, as packets may overtake each other.
            var seen = interval + roundTrip + new TimeSpan(roundTrip.Ticks / 4);
            _lossSeen = seen < _timeout ? seen.Value : _timeout;
            _newestArrival = start;
        }

        /// <summary>Sends a message.</summary>
        /// <param name="now">Not before the previous message's.</param>
        /// <returns>When the receiver can read it.</returns>
        public HeadsetTime Send(HeadsetTime now)
        {
            var (wait, timeout) = (_lossSeen, _timeout);
            HeadsetTime arrival;
            while (!_link.TrySend(now, out arrival))
            {
                now += wait;
                wait = timeout;
                timeout += timeout;
            }
            if (arrival < _newestArrival) arrival = _newestArrival;
            return _newestArrival = arrival;
        }
    }
}
