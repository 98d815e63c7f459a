using UnityEngine;

namespace Nowpose.Unity
{
    static class SessionSearch
    {
        /// <returns>The assigned one, else the one on the component's object or above it; null where there is none.</returns>
        public static MrilSession SessionOr(this Component component, MrilSession assigned) =>
            assigned != null ? assigned : component.GetComponentInParent<MrilSession>();
    }
}
