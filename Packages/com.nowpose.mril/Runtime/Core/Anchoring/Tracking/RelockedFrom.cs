using System;
using System.Collections.Generic;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>State of a base before a new search.</summary>
    readonly struct RelockedFrom
    {
        /// <summary>Time without a marker in view after which the search ends.</summary>
        static readonly TimeSpan SearchTimeout = TimeSpan.FromSeconds(15);

        readonly HeadsetTime _since;

        public RelockedFrom(BaseAnchorState state, bool isHeldByHand, HeadsetTime since)
        {
            State = state;
            IsHeldByHand = isHeldByHand;
            _since = since;
        }

        public BaseAnchorState State { get; }

        /// <summary>Whether the base was placed by hand before the search.</summary>
        public bool IsHeldByHand { get; }

        /// <summary>Returns whether no marker has been in view for <see cref="SearchTimeout"/>.</summary>
        public bool IsOver(HeadsetTime now, IReadOnlyList<TrackedMarker> markers)
        {
            if (now - _since < SearchTimeout) return false;
            for (var i = 0; i < markers.Count; i++)
                if (markers[i].LastSeen is HeadsetTime seen && now - seen < SearchTimeout) return false;
            return true;
        }
    }
}
