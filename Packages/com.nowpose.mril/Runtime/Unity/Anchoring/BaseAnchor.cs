using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Where the robot's base frame is in the room. Everything that shows the robot hangs below.</summary>
    [AddComponentMenu("Nowpose/Base Anchor")]
    [DisallowMultipleComponent]
    public sealed class BaseAnchor : MonoBehaviour
    {
        const float GizmoMetres = 0.2f;

        [SerializeField, Tooltip("Name of the robot cell, under which the headset keeps the place over restarts. Empty: it is not kept.")]
        string _cell = "";

        [SerializeField, Tooltip("Codes fixed to the robot's base, and where. None: the base stands where it is placed by hand.")]
        List<AnchorMarker> _markers = new List<AnchorMarker>();

        BaseMarker[] _used = Array.Empty<BaseMarker>();

        /// <summary>The anchor was placed or nudged by hand.</summary>
        public event Action Moved;

        /// <summary><see cref="State"/> is another one than before, or <see cref="Words"/> are.</summary>
        public event Action StateChanged;

        /// <summary>Name of the robot cell, under which the headset keeps the place; empty for none.</summary>
        public string Cell => _cell;

        /// <summary>How it is known where the base is.</summary>
        public BaseAnchorState State { get; private set; }

        /// <summary>The state in one line, with what is to be done about it.</summary>
        public string Words => State == BaseAnchorState.Placed ? "placed by hand" : "looking for markers";

        /// <summary>Takes other markers from now on, and another cell; what was locked is let go of.</summary>
        /// <param name="cell">Its name, under which the headset keeps the place over restarts; empty or null not to.</param>
        /// <param name="markers">Empty for a base that is placed by hand.</param>
        /// <exception cref="InputException">Two of them have the same payload.</exception>
        public void Use(string cell, IReadOnlyList<BaseMarker> markers)
        {
            if (markers == null) throw new ArgumentNullException(nameof(markers));
            var used = new BaseMarker[markers.Count];
            for (var i = 0; i < used.Length; i++) used[i] = markers[i] ?? throw new ArgumentNullException(nameof(markers));
            _cell = cell ?? "";
            _used = used;
            Relock();
        }

        /// <summary>Lets the markers say anew where the base is; until they have, it stays where it is and looks so.</summary>
        public void Relock()
        {
            var state = _used.Length > 0 ? BaseAnchorState.Searching : BaseAnchorState.Placed;
            if (state == State) return;
            State = state;
            StateChanged?.Invoke();
        }

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

        void OnEnable()
        {
            if (_used.Length > 0 || _markers.Count == 0) return;
            try
            {
                Use(_cell, _markers.ConvertAll(marker => marker.Read()));
            }
            catch (InputException fault)
            {
                ConsoleLog.Fail(this, "base anchor '" + name + "': " + fault.Message);
            }
        }

        void OnDrawGizmosSelected() => FrameGizmo.Draw(transform, GizmoMetres);

        static bool IsFinite(Vector3 v) => float.IsFinite(v.x) && float.IsFinite(v.y) && float.IsFinite(v.z);
    }
}
