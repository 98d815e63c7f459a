using System.Collections.Generic;
using Nowpose.Anchoring;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>The marker sources below an object, updated by periodic searches.</summary>
    sealed class MarkerSources
    {
        /// <summary>Search interval in s: components may be added and removed, and a search visits all objects.</summary>
        const float Seconds = 1;

        readonly List<IMarkerSource> _sources = new List<IMarkerSource>();
        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        float _due;

        /// <summary>Result of the last search; sources may have been disabled or destroyed since.</summary>
        public List<IMarkerSource> Found => _sources;

        /// <summary>Makes the next <see cref="Find"/> search again.</summary>
        public void Forget() => _due = 0;

        /// <summary>Searches for the sources, once a second.</summary>
        /// <returns>Whether it searched.</returns>
        public bool Find(Component root)
        {
            if (Time.unscaledTime < _due) return false;
            _due = Time.unscaledTime + Seconds;
            root.GetComponentsInChildren(true, _sources);
            return true;
        }

        /// <returns>The sightings of all enabled sources; the list is reused.</returns>
        public List<MarkerSighting> Read()
        {
            _sightings.Clear();
            foreach (var source in _sources)
                if (IsOn(source)) source.Read(_sightings);
            return _sightings;
        }

        /// <summary>Returns whether a source is enabled; false for a destroyed component.</summary>
        public static bool IsOn(object component) => !(component is Behaviour behaviour) || (behaviour != null && behaviour.isActiveAndEnabled);
    }
}
