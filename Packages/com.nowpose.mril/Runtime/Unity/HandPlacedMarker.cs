using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>A marker that the user places by hand. It replaces a printed marker that the device would detect.</summary>
    /// <remarks>
    /// The component that moves this object (by hand, by controller or by script) calls <see cref="BeginMove"/> and <see cref="EndMove"/>. The
    /// robot's base follows the object during the move, and is locked at the end of the move.
    /// </remarks>
    [AddComponentMenu("Nowpose/Hand Placed Marker")]
    [DisallowMultipleComponent]
    public sealed class HandPlacedMarker : MonoBehaviour, IMarkerSource
    {
        [SerializeField, Tooltip("Text of the base's marker that this object replaces. Empty: this object's transform is the robot's base "
            + "frame.")]
        string _payload = "";

        [SerializeField, Tooltip("The base that this object places if it has no payload. Empty: the first enabled Base Anchor below the session.")]
        BaseAnchor _anchor = null;

        [SerializeField, Tooltip("Keeps the base upright: of the rotation, only the heading counts. A hand turns an object by a few degrees, and "
            + "2 degrees displace a tool at a reach of 0.6 m by 21 mm. Switch it off for a robot on a wall, a ceiling or a slope.")]
        bool _keepUpright = true;

        [NonSerialized] string _id;
        MrilSession _session;
        HeadsetTime? _placed;
        BaseAnchor _placedBase;
        bool _isBelowBase, _isDecided;

        /// <summary>Whether a move is in progress.</summary>
        public bool IsMoving { get; private set; }

        /// <summary>Text of the printed marker that this object replaces; empty if the object represents the base frame itself.</summary>
        public string Payload => _payload;

        /// <summary>Identifies this marker among the sources.</summary>
        internal string Id => _id;

        /// <summary>Starts a move. The base follows this object's transform until <see cref="EndMove"/>.</summary>
        /// <remarks>Has no effect below a Base Anchor, because the object would move with the base that follows it.</remarks>
        public void BeginMove()
        {
            CheckParents();
            IsMoving = isActiveAndEnabled && !_isBelowBase;
            if (!IsMoving) return;
            _isDecided = false;
            var root = _session != null ? _session.transform : transform.root;
            (_placedBase, _isDecided) = (BaseAmong(root.GetComponentsInChildren<BaseAnchor>()), true);
        }

        /// <summary>Ends the move. Does nothing if no move is in progress.</summary>
        public void EndMove()
        {
            if (!IsMoving) return;
            IsMoving = false;
            _placed = _session.ClockOrDevices().Now;
        }

        /// <inheritdoc/>
        public void Read(List<MarkerSighting> markers)
        {
            if (!isActiveAndEnabled) return;
            if (IsMoving) _placed = _session.ClockOrDevices().Now;
            // Before the first move, the pose is the one in the scene and is unrelated to the room.
            if (!(_placed is HeadsetTime placed)) return;
            var pose = UnityPoses.ToRoom(transform.position, transform.rotation);
            markers.Add(new MarkerSighting(_id, _payload.Length == 0 ? null : _payload, pose, 0, placed, MarkerTracking.Placed, _keepUpright));
        }

        /// <summary>
        /// Returns the base that this object places if it has no payload; null if there is none. The start of a move decides it, because another base must
        /// not take over the place later.
        /// </summary>
        internal BaseAnchor BaseAmong(IReadOnlyList<BaseAnchor> bases)
        {
            if (_isDecided) return _placedBase;
            for (var i = 0; i < bases.Count && _anchor == null; i++)
                if (bases[i] != null && bases[i].isActiveAndEnabled) return bases[i];
            return _anchor;
        }

        /// <summary>Moves this object along with the base. Does nothing during a move by the user.</summary>
        /// <param name="place">Pose of the base in the scene.</param>
        /// <param name="markers">Markers of the base. The marker with this object's payload gives the pose relative to the base.</param>
        internal void Rest(Pose place, IReadOnlyList<TrackedMarker> markers)
        {
            if (IsMoving) return;
            if (_payload.Length == 0) transform.SetPositionAndRotation(place.position, place.rotation);
            for (var i = 0; i < markers.Count; i++)
            {
                if (markers[i].Marker.Payload != _payload) continue;
                var pose = UnityPoses.ToWorld(UnityPoses.ToRoom(place.position, place.rotation) * markers[i].Marker.MarkerInBase);
                transform.SetPositionAndRotation(pose.position, pose.rotation);
            }
        }

        void OnEnable()
        {
            _id ??= "hand " + Guid.NewGuid();
            _session = this.SessionOr(null);
            CheckParents();
        }

        void CheckParents()
        {
            var wasBelowBase = _isBelowBase;
            _isBelowBase = GetComponentInParent<BaseAnchor>() != null;
            if (_isBelowBase && !wasBelowBase) ConsoleLog.Fail(this, ComponentMessages.MarkerBelowBase(name));
        }

        void OnDisable() => EndMove();
    }
}
