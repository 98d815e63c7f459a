using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>A component that moves or changes parts according to a signal. Its parts look different while the signal is not current.</summary>
    interface ISignalComponent
    {
        /// <summary>Reason why the value of the signal is not current, in one line; null if it is current.</summary>
        string Fault { get; }
    }

    /// <summary>The components with a signal that affect the renderers of a pose, with the faults that were last drawn.</summary>
    sealed class SignalFaults
    {
        // Null for no fault.
        readonly Dictionary<MonoBehaviour, string> _drawn = new Dictionary<MonoBehaviour, string>();
        readonly List<MonoBehaviour> _changed = new List<MonoBehaviour>();

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

        /// <param name="components">Components that implement <see cref="ISignalComponent"/>.</param>
        public void Add(List<MonoBehaviour> components)
        {
            foreach (var component in components) _drawn[component] = FaultOf(component);
        }

        /// <summary>Reads all faults again. Allocates nothing if none has changed.</summary>
        /// <returns>Whether any fault has changed.</returns>
        public bool Update()
        {
            _changed.Clear();
            foreach (var known in _drawn)
                if (FaultOf(known.Key) != known.Value) _changed.Add(known.Key);
            foreach (var component in _changed) _drawn[component] = FaultOf(component);
            return _changed.Count > 0;
        }

        /// <summary>Returns the first fault of the components that affect one renderer; null if there is none.</summary>
        public string Of(PosePart part)
        {
            foreach (var component in part.Signals)
                if (_drawn[component] is string fault) return fault;
            return null;
        }

        // A disabled component does not follow its signal on purpose, and a destroyed one no longer affects anything.
        static string FaultOf(MonoBehaviour component) =>
            component != null && component.isActiveAndEnabled ? ((ISignalComponent)component).Fault : null;
    }
}
