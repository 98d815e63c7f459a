using System.Collections.Generic;

namespace Nowpose.Simulation
{
    /// <summary>The packets under way in one direction of a link. Not thread-safe.</summary>
    /// <typeparam name="T">A packet.</typeparam>
    sealed class PacketQueue<T>
    {
        readonly PacketLink _link;
        // By arrival; packets that arrive together in the order they were sent.
        readonly List<(HeadsetTime Arrival, T Packet)> _underWay = new List<(HeadsetTime Arrival, T Packet)>(256);

        public PacketQueue(PacketLink link) => _link = link;

        public int Count => _underWay.Count;

        /// <summary>When the next packet arrives; null while none is under way.</summary>
        public HeadsetTime? NextArrival => _underWay.Count == 0 ? (HeadsetTime?)null : _underWay[0].Arrival;

        /// <param name="now">Not before the previous packet's.</param>
        /// <returns>False when the link lost the packet.</returns>
        public bool TrySend(HeadsetTime now, T packet)
        {
            if (!_link.TrySend(now, out var arrival)) return false;
            var place = _underWay.Count;
            while (place > 0 && _underWay[place - 1].Arrival > arrival) place--;
            _underWay.Insert(place, (arrival, packet));
            return true;
        }

        /// <summary>Takes the next packet that has arrived.</summary>
        /// <param name="arrival">When it arrived; at most <paramref name="now"/>.</param>
        /// <returns>False when none has arrived.</returns>
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
}
