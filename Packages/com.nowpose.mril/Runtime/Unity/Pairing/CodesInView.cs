using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Pairing;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Shows a pairing what the marker sources below an object see at the moment.</summary>
    sealed class CodesInView
    {
        /// <summary>Devices look at a code every second or so, and go on telling of those that they saw long ago.</summary>
        static readonly TimeSpan Freshness = TimeSpan.FromSeconds(3);

        /// <summary>Sources may be added while the scene runs, as those of a device are once it has begun.</summary>
        const int FramesBetweenSearches = 60;

        readonly List<IMarkerSource> _sources = new List<IMarkerSource>();
        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        int _frames;

        public void Show(Component root, PairingFlow flow, HeadsetTime now)
        {
            if (_frames++ % FramesBetweenSearches == 0) root.GetComponentsInChildren(true, _sources);
            _sightings.Clear();
            foreach (var source in _sources)
                // One that was destroyed since the search is not asked any more.
                if (source is Behaviour behaviour && behaviour != null && behaviour.isActiveAndEnabled) source.Read(_sightings);
            foreach (var sighting in _sightings)
                if (sighting.Payload != null && IsInView(sighting, now)) flow.See(sighting.Payload, now);
        }

        static bool IsInView(in MarkerSighting sighting, HeadsetTime now) =>
            sighting.Tracking == MarkerTracking.Placed || (sighting.Tracking != MarkerTracking.None && now - sighting.LastSeen <= Freshness);
    }
}
