using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Protocol.Cell;

namespace Nowpose.Session.Cell
{
    /// <summary>Arrival times of the poses of stationary frames, which a source sends only once.</summary>
    sealed class StationaryArrivals
    {
        /// <summary>
        /// Time after which a pose that has not been sent again over a new connection is not current. A gateway sends its poses at once. The sources of a
        /// gateway that has restarted connect to it again within 1.8 s.
        /// </summary>
        static readonly TimeSpan Patience = ClockTicks.Span(2.5);

        readonly ConnectionStart _connection;
        readonly Dictionary<string, HeadsetTime> _arrivals = new Dictionary<string, HeadsetTime>(StringComparer.Ordinal);

        public StationaryArrivals(ConnectionStart connection) => _connection = connection;

        /// <summary>Records the arrival of a pose that was used.</summary>
        public void Add(string frame, HeadsetTime arrival) => _arrivals[frame] = arrival;

        /// <summary>Records that a frame was placed by hand, independently of the connection.</summary>
        public void Remove(string frame) => _arrivals.Remove(frame);

        /// <summary>
        /// Returns whether the stationary pose of a frame arrived later than a tracked pose. Tracked poses wait for a known control time, stationary ones do
        /// not.
        /// </summary>
        public bool IsLater(string frame, HeadsetTime arrivalOfTracked) =>
            _arrivals.TryGetValue(frame, out var arrival) && arrival >= arrivalOfTracked;

        /// <summary>Marks the frames of a tree whose poses have not been sent again since the newest connection began.</summary>
        public void Mark(FrameTree tree, HeadsetTime now)
        {
            if (!_connection.HasLasted(Patience, now)) return;
            foreach (var known in _arrivals)
                if (!_connection.Includes(known.Value) && tree.IndexOf(known.Key) is var index && index >= 0) tree[index].IsOutdated = true;
        }
    }
}
