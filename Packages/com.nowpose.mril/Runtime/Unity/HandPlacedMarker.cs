using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>A marker that the user places by hand, instead of one that the device detects.</summary>
    /// <remarks>
    /// The object that moves it (a hand, a controller, a script) reports the start and the end of the move. The base follows during the
    /// move and is locked at the end.
    /// </remarks>
    [AddComponentMenu("Nowpose/Hand Placed Marker")]
    [DisallowMultipleComponent]
    public sealed class HandPlacedMarker : MonoBehaviour, IMarkerSource
    {
        [SerializeField, Tooltip("Text of the marker of the base that this object replaces. Empty: this object's transform is the robot's base "
            + "frame.")]
        string _payload = "";

        string _id;
        MrilSession _session;
        HeadsetTime? _placed;

        /// <summary>Whether the marker is being moved.</summary>
        public bool IsMoving { get; private set; }

        /// <summary>Text of the marker that it represents; empty for the base frame itself.</summary>
        public string Payload => _payload;

        /// <summary>Starts a move: the base follows the transform.</summary>
        public void BeginMove() => IsMoving = isActiveAndEnabled;

        /// <summary>Ends the move. Does nothing unless the marker is being moved.</summary>
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
            // The initial place in a scene gives no information about the room.
            if (!(_placed is HeadsetTime placed)) return;
            var pose = UnityPoses.ToRoom(transform.position, transform.rotation);
            markers.Add(new MarkerSighting(_id, _payload.Length == 0 ? null : _payload, pose, 0, placed, MarkerTracking.Placed));
        }

        /// <summary>Moves the marker with the base unless the user moves it.</summary>
        /// <param name="place">Pose of the base.</param>
        /// <param name="markers">Markers of the base; the marker with the same payload determines the pose.</param>
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
        }

        void OnDisable() => EndMove();
    }
}
