using System.Collections.Generic;

namespace Nowpose.Unity.Rendering
{
    /// <summary>The actuated parts that move the renderers of a pose, with the faults that were last drawn.</summary>
    sealed class ActuatedFaults
    {
        // Null for no fault.
        readonly Dictionary<ActuatedPart, string> _drawn = new Dictionary<ActuatedPart, string>();
        readonly List<ActuatedPart> _changed = new List<ActuatedPart>();

        /// <summary>The first fault of all parts; null if there is none.</summary>
        public string First
        {
            get
            {
                foreach (var fault in _drawn.Values)
                    if (fault != null) return fault;
                return null;
            }
        }

        public void Clear() => _drawn.Clear();

        public void Add(List<ActuatedPart> parts)
        {
            foreach (var part in parts) _drawn[part] = FaultOf(part);
        }

        /// <summary>Reads all faults again. Allocates nothing if none has changed.</summary>
        /// <returns>Whether any fault has changed.</returns>
        public bool Update()
        {
            _changed.Clear();
            foreach (var known in _drawn)
                if (FaultOf(known.Key) != known.Value) _changed.Add(known.Key);
            foreach (var part in _changed) _drawn[part] = FaultOf(part);
            return _changed.Count > 0;
        }

        /// <summary>Returns the first fault of the parts that move one renderer; null if there is none.</summary>
        public string Of(PosePart part)
        {
            foreach (var actuated in part.Actuated)
                if (_drawn[actuated] is string fault) return fault;
            return null;
        }

        // A disabled part stays at the start of its stroke on purpose, and a destroyed one no longer moves anything.
        static string FaultOf(ActuatedPart part) => part != null && part.isActiveAndEnabled ? part.Fault : null;
    }
}
