using System.Collections.Generic;
using Nowpose.Anchoring;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>What tells of markers and what holds places, below a session or wherever the anchor's own root is.</summary>
    sealed class AnchorSources
    {
        readonly MarkerSources _sources = new MarkerSources();
        readonly List<ISpatialAnchors> _anchors = new List<ISpatialAnchors>();

        public bool IsEmpty => _sources.Found.Count == 0 && _anchors.Count == 0;

        /// <summary>The first that is enabled; null where none is.</summary>
        public ISpatialAnchors Anchors
        {
            get
            {
                foreach (var anchors in _anchors)
                    if (MarkerSources.IsOn(anchors)) return anchors;
                return null;
            }
        }

        /// <summary>Of the first source that has one; null when nothing is wrong.</summary>
        public string Problem
        {
            get
            {
                foreach (var source in _sources.Found)
                    if (MarkerSources.IsOn(source) && source is IMarkerProblem telling && telling.Problem != null) return telling.Problem;
                return null;
            }
        }

        /// <summary>Begins anew with the next <see cref="Find"/>.</summary>
        public void Forget() => _sources.Forget();

        public void Find(Transform root)
        {
            if (_sources.Find(root)) root.GetComponentsInChildren(true, _anchors);
        }

        /// <inheritdoc cref="MarkerSources.Read"/>
        public List<MarkerSighting> Read() => _sources.Read();

        /// <summary>Markers for the hand go along with the base while nobody moves them, so that a hand takes them from where it is.</summary>
        public void Rest(Pose place, IReadOnlyList<TrackedMarker> markers)
        {
            foreach (var source in _sources.Found)
                if (source is HandPlacedMarker hand && hand != null) hand.Rest(place, markers);
        }
    }
}
