using System;
using System.Collections.Generic;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>What a base was when it was to be locked anew.</summary>
    readonly struct RelockedFrom
    {
        /// <summary>Without a marker in view for so long nobody is about to look at one.</summary>
        static readonly TimeSpan Patience = TimeSpan.FromSeconds(15);

        readonly HeadsetTime _since;

        public RelockedFrom(BaseAnchorState state, bool isHeldByHand, HeadsetTime since)
        {
            State = state;
            IsHeldByHand = isHeldByHand;
            _since = since;
        }

        public BaseAnchorState State { get; }

        /// <summary>Whether a hand had put it there.</summary>
        public bool IsHeldByHand { get; }

        /// <summary>Whether no marker was seen for long.</summary>
        public bool IsOver(HeadsetTime now, IReadOnlyList<TrackedMarker> markers)
        {
            if (now - _since < Patience) return false;
            for (var i = 0; i < markers.Count; i++)
                if (markers[i].LastSeen is HeadsetTime seen && now - seen < Patience) return false;
            return true;
        }
    }
}
