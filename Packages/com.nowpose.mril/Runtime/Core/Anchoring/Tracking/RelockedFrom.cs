using System;
using System.Collections.Generic;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>State of a base before a new search, and the time of the search.</summary>
    sealed class RelockedFrom
    {
        /// <summary>Time without a marker in view after which the search ends.</summary>
        static readonly TimeSpan SearchTimeout = TimeSpan.FromSeconds(15);

        /// <summary>Maximum time between two frames. After a longer pause of the application, the time of the search starts again.</summary>
        static readonly TimeSpan MaxPause = TimeSpan.FromSeconds(1);

        HeadsetTime _since, _last;

        public RelockedFrom(BaseAnchorState state, HeadsetTime since)
        {
            State = state;
            _since = _last = since;
        }

        public BaseAnchorState State { get; }

        /// <summary>Processes one frame of the search.</summary>
        /// <returns>Whether no marker has been in view for <see cref="SearchTimeout"/>.</returns>
        public bool Follow(HeadsetTime now, IReadOnlyList<TrackedMarker> markers)
        {
            if (now - _last > MaxPause || now < _last) _since = now;
            _last = now;
            if (now - _since < SearchTimeout) return false;
            for (var i = 0; i < markers.Count; i++)
                if (markers[i].LastSeen is HeadsetTime seen && now - seen < SearchTimeout) return false;
            return true;
        }
    }
}
