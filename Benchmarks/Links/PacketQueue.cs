namespace Nowpose.Benchmarks.Links;

/// <summary>The packets in transit in one direction of a link. Not thread-safe.</summary>
/// <typeparam name="T">Type of a packet.</typeparam>
sealed class PacketQueue<T>
{
    readonly PacketLink _link;
    // Packets sorted by arrival; packets that arrive at the same time are in the order in which they were sent.
    readonly List<(HeadsetTime Arrival, T Packet)> _underWay = new List<(HeadsetTime Arrival, T Packet)>(256);

    public PacketQueue(PacketLink link) => _link = link;

    /// <summary>Arrival time of the next packet; null if none is in transit.</summary>
    public HeadsetTime? NextArrival => _underWay.Count == 0 ? (HeadsetTime?)null : _underWay[0].Arrival;

    /// <param name="now">Time of sending, not before the time of the previous packet.</param>
    /// <returns>False if the link lost the packet.</returns>
    public bool TrySend(HeadsetTime now, T packet)
    {
        if (!_link.TrySend(now, out var arrival)) return false;
        var place = _underWay.Count;
        while (place > 0 && _underWay[place - 1].Arrival > arrival) place--;
        _underWay.Insert(place, (arrival, packet));
        return true;
    }

    /// <summary>Removes the next packet that has arrived.</summary>
    /// <param name="arrival">Arrival time; at most <paramref name="now"/>.</param>
    /// <returns>False if none has arrived.</returns>
    public bool TryReceive(HeadsetTime now, out T packet, out HeadsetTime arrival)
    {
        packet = default;
        arrival = default;
        if (_underWay.Count == 0 || _underWay[0].Arrival > now) return false;
        (arrival, packet) = _underWay[0];
        _underWay.RemoveAt(0);
        return true;
    }
}
