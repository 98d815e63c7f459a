using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Assigns each drawn part to one Pose Appearance.</summary>
    static class PartOwner
    {
        /// <summary>
        /// Returns whether a part belongs to an appearance: to the nearest one above it, even if that one is disabled, and to the last one of an object.
        /// The last one is the one that the user has added to an instance of an imported robot. Works outside play mode, too.
        /// </summary>
        /// <param name="label">Label of the appearance, which is not one of its parts; may be null.</param>
        public static bool Owns(this PoseAppearance appearance, Renderer part, TextMesh label)
        {
            if (label != null && part.gameObject == label.gameObject) return false;
            var nearest = part.GetComponentInParent<PoseAppearance>(true).GetComponents<PoseAppearance>();
            return nearest[nearest.Length - 1] == appearance;
        }
    }
}
