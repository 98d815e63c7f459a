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
            if (_sources.Find(root)) root.GetComponentsInChildren(true, _anchors);
        }

        /// <inheritdoc cref="MarkerSources.Read"/>
        public List<MarkerSighting> Read() => _sources.Read();

        /// <summary>Moves the hand-placed markers along with the base, except the markers that the user is moving.</summary>
        public void Rest(Pose place, IReadOnlyList<TrackedMarker> markers)
        {
            foreach (var source in _sources.Found)
                if (source is HandPlacedMarker hand && hand != null) hand.Rest(place, markers);
        }
    }
}
