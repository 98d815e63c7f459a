using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// The appearances of the parts that a component moves or changes. They read their parts again when the component is added, or it or one of its
    /// parents gets another parent; otherwise the parts could look current although they are not.
    /// </summary>
    sealed class AppearancesOfParts
    {
        readonly List<Transform> _above = new List<Transform>();

        /// <summary>
        /// Refreshes the same appearances as <see cref="Refresh"/>, unless the component has the same parents as at the last call. Call it when the
        /// component is enabled.
        /// </summary>
        public void RefreshIfMoved(Component component)
        {
            // A signal may switch its parts on and off at any time. The appearances list inactive and disabled components as well.
            if (!IsBelowSameParents(component.transform)) Refresh(component);
        }

        /// <summary>Refreshes the appearances above the component, those that were above it at the last call, and those below it.</summary>
        /// <remarks>
        /// A component whose object was never active has not called this method, because Unity calls none of its methods. If the object is moved before
        /// it is first active, its former appearances therefore keep its parts.
        /// </remarks>
        public void Refresh(Component component)
        {
            // An appearance restores the parts that it no longer draws. It must do this before another one stores their original look.
            foreach (var former in _above)
                if (former != null && !component.transform.IsChildOf(former)) RefreshAt(former);
            _above.Clear();
            for (var at = component.transform; at != null; at = at.parent) _above.Add(at);
            for (var i = _above.Count - 1; i >= 0; i--) RefreshAt(_above[i]);
            foreach (var below in component.GetComponentsInChildren<PoseAppearance>(true))
                if (below.transform != component.transform) below.Refresh();
        }

        bool IsBelowSameParents(Transform component)
        {
            var count = 0;
            for (var at = component; at != null; at = at.parent, count++)
                if (count == _above.Count || _above[count] != at) return false;
            return count == _above.Count;
        }

        static void RefreshAt(Transform place)
        {
            foreach (var each in place.GetComponents<PoseAppearance>()) each.Refresh();
        }
    }
}
