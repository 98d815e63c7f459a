using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>The viewer of the scene.</summary>
    static class Viewer
    {
        /// <summary>The main camera, which is the wearer's head; null if there is none.</summary>
        public static Transform Head
        {
            get
            {
                var camera = Camera.main;
                return camera != null ? camera.transform : null;
            }
        }

        /// <summary>Returns the upright rotation with which a text faces the viewer: the engine's texts are read along their z axis.</summary>
        public static Quaternion Facing(Vector3 text, Vector3 viewer)
        {
            var away = text - viewer;
            away.y = 0;
            return away.sqrMagnitude > 1e-6f ? Quaternion.LookRotation(away, Vector3.up) : Quaternion.identity;
        }
    }
}
