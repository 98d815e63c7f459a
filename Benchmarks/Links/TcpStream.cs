namespace Nowpose.Benchmarks.Links;

/// <summary>One direction of a TCP connection over a packet link: a lost packet is retransmitted and delays all later packets.</summary>
/// <remarks>
/// Retransmissions follow RFC 6298 with Linux's minimum: the first after the round-trip time plus 200 ms, each subsequent retransmission after
/// twice the previous timeout. In a stream of messages, the first retransmission is earlier (RFC 8985), because the selective acknowledgement of
/// the next message reveals the loss. Seeded; not thread-safe.
/// </remarks>
sealed class TcpStream
{
    static readonly TimeSpan MinTimeout = TimeSpan.FromMilliseconds(200);

    readonly PacketLink _link;
    readonly TimeSpan _timeout, _lossSeen;
    HeadsetTime _newestArrival;

    /// <param name="start">Time to which the link's stalls are relative.</param>
    /// <param name="interval">Interval between messages; null if each message waits for a response to the previous message.</param>
    public TcpStream(LinkProfile profile, HeadsetTime start, int seed, TimeSpan? interval = null)
    {
        // Each packet has its own delay; this class restores the order.
        _link = new PacketLink(profile, start, seed, keepsOrder: false);
        var roundTrip = ClockTicks.Span(2 * (profile.BaseMs + profile.MeanJitterMs) / 1000);
        _timeout = MinTimeout + roundTrip;
        // According to RFC 8985, a sender waits for an additional quarter of the round-trip time, because packets may overtake each other.
        var seen = interval + roundTrip + new TimeSpan(roundTrip.Ticks / 4);
        _lossSeen = seen < _timeout ? seen.Value : _timeout;
        _newestArrival = start;
    }

    /// <summary>Sends a message.</summary>
    /// <param name="now">Time of sending, not before the time of the previous message.</param>
    /// <returns>Time at which the receiver can read the message.</returns>
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
