using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Assigns each drawn part to one Pose Appearance.</summary>
    static class PartOwner
    {
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
                foreach (var each in at.GetComponents<PoseAppearance>())
                    if (each.IsOwner) owner = each;
            return owner == appearance;
        }
    }
}
