using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>Finds the head of the viewer, and computes the rotation of text that faces it.</summary>
    static class Viewer
    {
        /// <summary>Transform of the main camera, which is the wearer's head; null if the scene has no main camera.</summary>
        public static Transform Head
        {
            get
            {
                var camera = Camera.main;
                return camera != null ? camera.transform : null;
            }
        }

        /// <summary>
        /// Returns the upright rotation with which a TextMesh faces the viewer. The z axis of a TextMesh points away from its reader.
        /// </summary>
        public static Quaternion Facing(Vector3 text, Vector3 viewer)
        {
            var away = text - viewer;
            away.y = 0;
            return away.sqrMagnitude > 1e-6f ? Quaternion.LookRotation(away, Vector3.up) : Quaternion.identity;
        }
    }
}
