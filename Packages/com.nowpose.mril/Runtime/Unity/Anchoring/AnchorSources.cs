using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>Finds the marker sources and spatial anchors below an object.</summary>
    sealed class AnchorSources
    {
        readonly MarkerSources _sources = new MarkerSources();
        readonly List<ISpatialAnchors> _anchors = new List<ISpatialAnchors>();
        readonly List<BaseAnchor> _bases = new List<BaseAnchor>();

        public bool IsEmpty => _sources.Found.Count == 0 && _anchors.Count == 0;

        /// <summary>The first enabled provider of spatial anchors; null if there is none.</summary>
        public ISpatialAnchors Anchors
        {
            get
            {
                foreach (var anchors in _anchors)
                    if (MarkerSources.IsOn(anchors)) return anchors;
                return null;
            }
        }

        /// <summary>
        /// The problem of the first enabled marker source that reports one, or that no enabled source can detect codes; null if nothing is wrong.
        /// </summary>
        public string Problem
        {
            get
            {
                var hasDetector = false;
                foreach (var source in _sources.Found)
                {
                    if (!MarkerSources.IsOn(source)) continue;
                    if (source is IMarkerProblem reporter && reporter.Problem != null) return reporter.Problem;
                    hasDetector |= !(source is HandPlacedMarker);
                }
                return hasDetector ? null : BaseMessages.NoMarkerSource;
            }
        }

        /// <summary>Causes the next <see cref="Find"/> to search without delay.</summary>
        public void Forget() => _sources.Forget();

        public void Find(Transform root)
        {
            if (!_sources.Find(root)) return;
            root.GetComponentsInChildren(true, _anchors);
            root.GetComponentsInChildren(true, _bases);
        }

        /// <summary>Reads the sightings of all enabled sources, except markers placed by hand that belong to another base.</summary>
        public List<MarkerSighting> ReadFor(BaseTracker tracker)
        {
            var sightings = _sources.Read();
            for (var i = sightings.Count - 1; i >= 0; i--)
                if (sightings[i].Tracking == MarkerTracking.Placed && IsOfAnother(tracker, sightings[i].Payload, sightings[i].Id)) sightings.RemoveAt(i);
            return sightings;
        }

        bool IsOfAnother(BaseTracker tracker, string payload, string id)
        {
            foreach (var source in _sources.Found)
                if (payload == null && source is HandPlacedMarker hand && hand != null && hand.Id == id) return !IsPlacedBy(hand, tracker);
            if (tracker.Has(payload)) return false;
            foreach (var other in _bases)
                if (other != null && other.Tracker != tracker && other.Tracker?.Has(payload) == true) return true;
            return false;
        }

        // A marker without a payload places one base: otherwise several robots would be displayed at the same place.
        bool IsPlacedBy(HandPlacedMarker hand, BaseTracker tracker) =>
            hand.BaseAmong(_bases) is BaseAnchor placed && placed != null && placed.Tracker == tracker;

        /// <summary>Moves the hand-placed markers along with the base, except the markers that the user is moving.</summary>
        public void Rest(Pose place, BaseTracker tracker)
        {
            foreach (var source in _sources.Found)
                if (source is HandPlacedMarker hand && hand != null && (hand.Payload.Length > 0 || IsPlacedBy(hand, tracker))) hand.Rest(place, tracker.Markers);
        }
    }
}
