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

        /// <summary>Refreshes the appearances above the component, those that were above it at the last call, and those below it.</summary>
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

        static void RefreshAt(Transform place)
        {
            foreach (var each in place.GetComponents<PoseAppearance>()) each.Refresh();
        }
    }
}
