using System.Collections.Generic;
using Nowpose.Anchoring;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>What tells of markers and what holds places, below a session or wherever the anchor's own root is.</summary>
    sealed class AnchorSources
    {
        /// <summary>Components come and go; looking for them costs a walk through all objects.</summary>
        const float Seconds = 1;

        readonly List<IMarkerSource> _sources = new List<IMarkerSource>();
        readonly List<ISpatialAnchors> _anchors = new List<ISpatialAnchors>();
        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        float _due;

        public bool IsEmpty => _sources.Count == 0 && _anchors.Count == 0;

        /// <summary>The first that is enabled; null where none is.</summary>
        public ISpatialAnchors Anchors
        {
            get
            {
                foreach (var anchors in _anchors)
                    if (IsOn(anchors)) return anchors;
                return null;
            }
        }

        /// <summary>Of the first source that has one; null when nothing is wrong.</summary>
        public string Problem
        {
            get
            {
                foreach (var source in _sources)
                    if (IsOn(source) && source is IMarkerProblem telling && telling.Problem != null) return telling.Problem;
                return null;
            }
        }

        /// <summary>Begins anew with the next <see cref="Find"/>.</summary>
        public void Forget() => _due = 0;

        public void Find(Transform root)
        {
            if (Time.unscaledTime < _due) return;
            _due = Time.unscaledTime + Seconds;
            root.GetComponentsInChildren(true, _sources);
            root.GetComponentsInChildren(true, _anchors);
        }

        /// <returns>What all that are enabled tell; the same list each time.</returns>
        public List<MarkerSighting> Read()
        {
            _sightings.Clear();
            foreach (var source in _sources)
                if (IsOn(source)) source.Read(_sightings);
            return _sightings;
        }

        /// <summary>Markers for the hand go along with the base while nobody moves them, so that a hand takes them from where it is.</summary>
        public void Rest(Pose place, IReadOnlyList<TrackedMarker> markers)
        {
            foreach (var source in _sources)
                if (source is HandPlacedMarker hand && hand != null) hand.Rest(place, markers);
        }

        // What is destroyed, or switched off, tells nothing.
        static bool IsOn(object component) => !(component is Behaviour behaviour) || (behaviour != null && behaviour.isActiveAndEnabled);
    }
}
