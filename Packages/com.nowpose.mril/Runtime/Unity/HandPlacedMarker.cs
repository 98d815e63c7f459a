using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>A marker that somebody holds to where it is to be, instead of one that the device sees.</summary>
    /// <remarks>
    /// What moves it (a hand, a controller, a script) says when it begins and when it has ended. The base follows it meanwhile, and
    /// is locked when it is put down.
    /// </remarks>
    [AddComponentMenu("Nowpose/Hand Placed Marker")]
    [DisallowMultipleComponent]
    public sealed class HandPlacedMarker : MonoBehaviour, IMarkerSource
    {
        [SerializeField, Tooltip("Text of the marker of the base that it stands for. Empty: its transform is the robot's base frame itself.")]
        string _payload = "";

        string _id;
        MrilSession _session;
        HeadsetTime? _placed;

        /// <summary>Whether somebody moves it at the moment.</summary>
        public bool IsMoving { get; private set; }

        /// <summary>Text of the marker that it stands for; empty for the base frame itself.</summary>
        public string Payload => _payload;

        /// <summary>From now on the transform is moved, and the base with it.</summary>
        public void BeginMove() => IsMoving = isActiveAndEnabled;

        /// <summary>It has been put down. Does nothing unless it was being moved.</summary>
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
            // Where a scene has it before anybody touched it says nothing about the room.
            if (!(_placed is HeadsetTime placed)) return;
            var pose = UnityPoses.ToRoom(transform.position, transform.rotation);
            markers.Add(new MarkerSighting(_id, _payload.Length == 0 ? null : _payload, pose, 0, placed, MarkerTracking.Placed));
        }

        /// <summary>Goes along with the base unless somebody moves it.</summary>
        /// <param name="place">Of the base.</param>
        /// <param name="markers">Of the base; one that it has not, this one does not stand for.</param>
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
