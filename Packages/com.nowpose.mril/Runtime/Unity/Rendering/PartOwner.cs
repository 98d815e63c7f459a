using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Assigns each drawn part to one Pose Appearance.</summary>
    static class PartOwner
    {
        // The appearances on one object. An array for each renderer and each of its parents would be created otherwise.
        static readonly List<PoseAppearance> Found = new List<PoseAppearance>();

        /// <summary>
        /// Returns whether a part belongs to an appearance: to the nearest enabled one above it, and to the last enabled one of an object. The last one
        /// is the one that the user has added to an instance of an imported robot. Works outside play mode, too.
        /// </summary>
        /// <param name="label">Label of the appearance, which is not one of its parts; may be null.</param>
        public static bool Owns(this PoseAppearance appearance, Renderer part, TextMesh label)
        {
            if (label != null && part.gameObject == label.gameObject) return false;
            PoseAppearance owner = null;
            for (var at = part.transform; at != null && owner == null; at = at.parent)
            {
                at.GetComponents(Found);
                foreach (var each in Found)
                    if (each.IsOwner) owner = each;
            }
            Found.Clear();
            return owner == appearance;
        }
    }
}
