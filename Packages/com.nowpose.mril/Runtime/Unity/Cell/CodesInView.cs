using System;
using Nowpose.Anchoring;
using Nowpose.Pairing;
using Nowpose.Unity.Anchoring;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>Shows a pairing what the marker sources below an object see at the moment.</summary>
    sealed class CodesInView
    {
        /// <summary>Devices look at a code every second or so, and go on telling of those that they saw long ago.</summary>
        static readonly TimeSpan Freshness = TimeSpan.FromSeconds(3);

        readonly MarkerSources _sources = new MarkerSources();

        public void Show(Component root, PairingFlow flow, HeadsetTime now)
        {
            _sources.Find(root);
            foreach (var sighting in _sources.Read())
                if (sighting.Payload != null && IsInView(sighting, now)) flow.See(sighting.Payload, now);
        }

        static bool IsInView(in MarkerSighting sighting, HeadsetTime now) =>
            sighting.Tracking == MarkerTracking.Placed || (sighting.Tracking != MarkerTracking.None && now - sighting.LastSeen <= Freshness);
    }
}
