using System;
using System.Collections.Generic;

namespace Nowpose.Session.Cell
{
    /// <summary>Arrival times of the poses of stationary frames, which a source sends only once.</summary>
    sealed class StationaryArrivals
    {
        readonly Dictionary<string, HeadsetTime> _arrivals = new Dictionary<string, HeadsetTime>(StringComparer.Ordinal);

        /// <summary>Records the arrival of a pose that was used.</summary>
        public void Add(string frame, HeadsetTime arrival) => _arrivals[frame] = arrival;

        /// <summary>
        /// Returns whether the stationary pose of a frame arrived later than a tracked pose. Tracked poses wait for a known control time, stationary ones do
        /// not.
        /// </summary>
        public bool IsLater(string frame, HeadsetTime arrivalOfTracked) =>
            _arrivals.TryGetValue(frame, out var arrival) && arrival >= arrivalOfTracked;
    }
}
