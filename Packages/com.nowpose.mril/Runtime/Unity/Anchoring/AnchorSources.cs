using System.Collections.Generic;
using Nowpose.Anchoring;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>The marker sources and spatial anchors below a session, or below the anchor's own root object.</summary>
    sealed class AnchorSources
    {
        readonly MarkerSources _sources = new MarkerSources();
        readonly List<ISpatialAnchors> _anchors = new List<ISpatialAnchors>();

        public bool IsEmpty => _sources.Found.Count == 0 && _anchors.Count == 0;

        /// <summary>The first enabled spatial anchors; null if there are none.</summary>
        public ISpatialAnchors Anchors
        {
            get
            {
                foreach (var anchors in _anchors)
                    if (MarkerSources.IsOn(anchors)) return anchors;
                return null;
            }
        }

        /// <summary>Problem of the first source that has one; null if there is none.</summary>
        public string Problem
        {
            get
            {
                foreach (var source in _sources.Found)
                    if (MarkerSources.IsOn(source) && source is IMarkerProblem telling && telling.Problem != null) return telling.Problem;
                return null;
            }
        }

        /// <summary>Makes the next <see cref="Find"/> search again.</summary>
        public void Forget() => _sources.Forget();

        public void Find(Transform root)
        {
            if (_sources.Find(root)) root.GetComponentsInChildren(true, _anchors);
        }

        /// <inheritdoc cref="MarkerSources.Read"/>
        public List<MarkerSighting> Read() => _sources.Read();

        /// <summary>Moves the hand-placed markers that no hand holds along with the base, so that a hand finds them at their place.</summary>
        public void Rest(Pose place, IReadOnlyList<TrackedMarker> markers)
        {
            foreach (var source in _sources.Found)
                if (source is HandPlacedMarker hand && hand != null) hand.Rest(place, markers);
        }
    }
}
