namespace Nowpose.Benchmarks.Links;

/// <summary>Determines for each packet in one direction of a link whether and when it arrives. Seeded; not thread-safe.</summary>
sealed class PacketLink
{
    readonly LinkProfile _profile;
    readonly HeadsetTime _start;
    readonly bool _keepsOrder;
    readonly Random _random;
    HeadsetTime _newestArrival;

    /// <param name="start">Time to which stalls are relative. Use the same value for both directions.</param>
    /// <param name="keepsOrder">Whether packets arrive in the order in which they were sent, as with the queue of a real link.</param>
    public PacketLink(LinkProfile profile, HeadsetTime start, int seed, bool keepsOrder = true)
    {
        _profile = profile;
        _start = _newestArrival = start;
        _keepsOrder = keepsOrder;
        _random = new Random(seed);
    }

    /// <summary>Sends a packet.</summary>
    /// <param name="now">Time of sending, not before the time of the previous packet.</param>
    /// <param name="arrival">Time at which the packet leaves the link at the far end.</param>
    /// <returns>False if the packet is lost.</returns>
    public bool TrySend(HeadsetTime now, out HeadsetTime arrival)
    {
        // Draws both numbers for every packet, so that the loss of a packet does not change the delays of later packets.
        var jitterMs = -_profile.MeanJitterMs * Math.Log(1 - _random.NextDouble());
        var isLost = _random.NextDouble() < _profile.Loss;
        arrival = now + ClockTicks.Span((_profile.BaseMs + jitterMs) / 1000);
        if (isLost) return false;
        if (_keepsOrder && arrival < _newestArrival) arrival = _newestArrival;
        arrival = _start + _profile.EndOfStall(arrival - _start);
        _newestArrival = arrival;
        return true;
    }
}
