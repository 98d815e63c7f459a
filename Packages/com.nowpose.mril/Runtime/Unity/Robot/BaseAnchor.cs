using System;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Where the robot's base frame is in the room. Everything that shows the robot hangs below.</summary>
    [AddComponentMenu("Nowpose/Base Anchor")]
    [DisallowMultipleComponent]
    public sealed class BaseAnchor : MonoBehaviour
    {
        const float GizmoMetres = 0.2f;

        /// <summary>The anchor was placed or nudged.</summary>
        public event Action Moved;

        /// <summary>Puts the base frame to a place in the world.</summary>
        /// <param name="position">Of its origin, metres.</param>
        /// <param name="rotation">Turns Unity's axes (x right, y up, z forward) to the robot's; of any length but zero.</param>
        /// <exception cref="ArgumentException">Not finite, or no rotation.</exception>
        public void Place(Vector3 position, Quaternion rotation)
        {
            var length = Mathf.Sqrt(Quaternion.Dot(rotation, rotation));
            if (!IsFinite(position)) throw new ArgumentException("position " + position + " is not finite", nameof(position));
            if (!(length > 0) || float.IsInfinity(length)) throw new ArgumentException("rotation " + rotation + " turns nowhere", nameof(rotation));
            transform.SetPositionAndRotation(
                position, new Quaternion(rotation.x / length, rotation.y / length, rotation.z / length, rotation.w / length));
            Moved?.Invoke();
        }

        /// <summary>Corrects the placement by a little, along and about the anchor's own axes.</summary>
        /// <param name="metres">Right, up and forward as seen from the robot.</param>
        /// <param name="degreesAboutUp">Clockwise seen from above, as Unity turns.</param>
        /// <exception cref="ArgumentException">Not finite.</exception>
        public void Nudge(Vector3 metres, float degreesAboutUp)
        {
            if (!float.IsFinite(degreesAboutUp)) throw new ArgumentException(degreesAboutUp + "° is not finite", nameof(degreesAboutUp));
            Place(
                transform.position + transform.rotation * metres,
                transform.rotation * Quaternion.AngleAxis(degreesAboutUp, Vector3.up));
        }

        void OnDrawGizmosSelected() => FrameGizmo.Draw(transform, GizmoMetres);

        static bool IsFinite(Vector3 v) => float.IsFinite(v.x) && float.IsFinite(v.y) && float.IsFinite(v.z);
    }
}
