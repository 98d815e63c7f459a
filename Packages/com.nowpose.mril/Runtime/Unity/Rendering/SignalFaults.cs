using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// A component that moves or changes the parts at and below its object according to a signal or to joints. The parts look different while it has a
    /// fault.
    /// </summary>
    interface ISignalComponent
    {
        /// <summary>Reason why the parts may not be in the state of the real parts, in one line; null if they are.</summary>
        string Fault { get; }

        /// <summary>Label of the parts while there is a fault, in a few words.</summary>
        string FaultLabel { get; }
    }

    /// <summary>The components with a signal or joints that affect the renderers of a pose, with the faults that were last drawn.</summary>
    sealed class SignalFaults
    {
        // The fault is null if there is none.
        readonly Dictionary<MonoBehaviour, (string Label, string Fault)> _drawn = new Dictionary<MonoBehaviour, (string, string)>();
        readonly List<MonoBehaviour> _changed = new List<MonoBehaviour>();

        /// <summary>The first fault of all parts, with its label; a null fault if there is none.</summary>
        public (string Label, string Fault) First
        {
            get
            {
                foreach (var drawn in _drawn.Values)
                    if (drawn.Fault != null) return drawn;
                return default;
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

        /// <summary>Returns the first fault of the components that affect one renderer, with its label; a null fault if there is none.</summary>
        public (string Label, string Fault) Of(PosePart part)
        {
            foreach (var component in part.Signals)
                if (_drawn[component] is var drawn && drawn.Fault != null) return drawn;
            return default;
        }

        // A disabled component has a fault, because its parts stay in their last state. Parts on an inactive object are not drawn, and a destroyed
        // component no longer affects anything.
        static (string Label, string Fault) FaultOf(MonoBehaviour component)
        {
            if (component == null || !component.gameObject.activeInHierarchy) return default;
            var driver = (ISignalComponent)component;
            return driver.Fault is string fault ? (driver.FaultLabel, fault) : default;
        }
    }
}
