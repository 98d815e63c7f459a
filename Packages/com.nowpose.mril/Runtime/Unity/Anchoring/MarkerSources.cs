using System.Collections.Generic;
using Nowpose.Anchoring;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>The marker sources below an object, as they come and go.</summary>
    sealed class MarkerSources
    {
        /// <summary>Components come and go; looking for them costs a walk through all objects.</summary>
        const float Seconds = 1;

        readonly List<IMarkerSource> _sources = new List<IMarkerSource>();
        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        float _due;

        /// <summary>As of the last search; some may be switched off or destroyed by now.</summary>
        public List<IMarkerSource> Found => _sources;

        /// <summary>Begins anew with the next <see cref="Find"/>.</summary>
        public void Forget() => _due = 0;

        /// <summary>Looks for them, once a second.</summary>
        /// <returns>Whether it looked.</returns>
        public bool Find(Component root)
        {
            if (Time.unscaledTime < _due) return false;
            _due = Time.unscaledTime + Seconds;
            root.GetComponentsInChildren(true, _sources);
            return true;
        }

        /// <returns>What all that are enabled tell; the same list each time.</returns>
        public List<MarkerSighting> Read()
        {
            _sightings.Clear();
            foreach (var source in _sources)
                if (IsOn(source)) source.Read(_sightings);
            return _sightings;
        }

        /// <summary>False for a component that was destroyed or is switched off: it tells nothing.</summary>
        public static bool IsOn(object component) => !(component is Behaviour behaviour) || (behaviour != null && behaviour.isActiveAndEnabled);
    }
}
