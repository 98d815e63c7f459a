using System;
using Nowpose.Anchoring;
using Nowpose.Pairing;
using Nowpose.Unity.Anchoring;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>Passes the codes that are currently in view of the marker sources below an object to a pairing.</summary>
    sealed class CodesInView
    {
        /// <summary>
        /// Maximum age of a sighting. Devices scan a code about once a second, and continue to report codes that they saw long ago.
        /// </summary>
        static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(3);

        readonly MarkerSources _sources = new MarkerSources();

        public void Show(Component root, PairingFlow flow, HeadsetTime now)
        {
            _sources.Find(root);
            foreach (var sighting in _sources.Read())
                if (sighting.Payload != null && IsInView(sighting, now)) flow.See(sighting.Payload, now);
        }

        static bool IsInView(in MarkerSighting sighting, HeadsetTime now) =>
            sighting.Tracking == MarkerTracking.Placed || (sighting.Tracking != MarkerTracking.None && now - sighting.LastSeen <= MaxAge);
    }
}
