using System.Collections.Generic;
using Nowpose.Anchoring;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>Finds the marker sources below an object by periodic searches.</summary>
    sealed class MarkerSources
    {
        /// <summary>
        /// Search interval in s. Sources may be added at any time, but a search visits all objects, so it does not run in each frame.
        /// </summary>
        const float Seconds = 1;

        readonly List<IMarkerSource> _sources = new List<IMarkerSource>();
        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        double _due;

        /// <summary>Result of the last search. It may contain sources that have since been disabled or destroyed.</summary>
        public List<IMarkerSource> Found => _sources;

        /// <summary>Causes the next <see cref="Find"/> to search without delay.</summary>
        public void Forget() => _due = 0;

        /// <summary>Searches for the sources unless the last search was less than a second ago. Call once per frame.</summary>
        /// <returns>True if it searched.</returns>
        public bool Find(Component root)
        {
            if (Time.unscaledTimeAsDouble < _due) return false;
            _due = Time.unscaledTimeAsDouble + Seconds;
            root.GetComponentsInChildren(true, _sources);
            return true;
        }

        /// <summary>Reads the sightings of all enabled sources.</summary>
        /// <returns>A list that the next call overwrites.</returns>
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
