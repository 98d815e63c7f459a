using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>The markers of a base, each with its own payload.</summary>
    sealed class MarkerSet
    {
        const int MaxCount = 32;

        TrackedMarker[] _markers = Array.Empty<TrackedMarker>();

        public IReadOnlyList<TrackedMarker> All => _markers;

        public int Count => _markers.Length;

        public bool HasMoved
        {
            get
            {
                foreach (var marker in _markers)
                    if (marker.HasMoved) return true;
                return false;
            }
        }

        /// <summary>Replaces the markers. Markers that are also in the new list keep their sightings.</summary>
        /// <returns>Whether all parts of a lock are still in the list.</returns>
        /// <exception cref="InputException">
        /// Two markers have the same payload, or there are too many. In this case, the set does not change.
        /// </exception>
        public bool Replace(IReadOnlyList<BaseMarker> markers, AnchoringSettings settings)
        {
            SettingRange.RequireCount(markers.Count, 0, MaxCount, SettingNames.MarkersOfBase);
            var tracked = new TrackedMarker[markers.Count];
            for (var i = 0; i < tracked.Length; i++)
            {
                var marker = markers[i] ?? throw new ArgumentNullException(nameof(markers));
                for (var j = 0; j < i; j++)
                    if (markers[j].Payload == marker.Payload)
                        throw new InputException(MarkerMessages.PayloadTwice(MarkerName.Of(marker.Payload)));
                tracked[i] = Array.Find(_markers, known => known.Marker.IsSameAs(marker)) ?? new TrackedMarker(marker, settings);
            }
            var hasAllParts = Array.TrueForAll(_markers, known => !known.IsPart || Array.IndexOf(tracked, known) >= 0);
            _markers = tracked;
            return hasAllParts;
        }

        public void Restart()
        {
            foreach (var marker in _markers) marker.Restart();
        }

        public void RemoveSightings()
        {
            foreach (var marker in _markers) marker.RemoveSightings();
        }

        /// <param name="payload">Payload of the marker; null if the pose of the base itself is requested.</param>
        /// <returns>The pose of the marker with this payload in the base frame; null if there is none.</returns>
        public RigidTransform? PoseInBase(string payload)
        {
            if (payload == null) return RigidTransform.Identity;
            foreach (var marker in _markers)
                if (marker.Marker.Payload == payload) return marker.Marker.MarkerInBase;
            return null;
        }

        /// <summary>Keeps the place of the markers in the room when a person moves the base.</summary>
        /// <param name="by">New pose of the base relative to its previous pose.</param>
        public void Nudge(in RigidTransform by)
        {
            foreach (var marker in _markers) marker.Nudge(by);
        }

        /// <summary>Returns whether a part of the lock that is in view agrees with its expected pose.</summary>
        public bool HasAgreement(HeadsetTime now)
        {
            foreach (var marker in _markers)
                if (marker.IsPart && !marker.HasMoved && marker.Watch.IsKnown && marker.IsFresh(now)) return true;
            return false;
        }

        /// <param name="watched">Pose of the base against which the sighting is checked; null to skip the check.</param>
        /// <param name="onlyParts">Whether only parts of the lock are checked.</param>
        /// <returns>Whether the sighting was accepted.</returns>
        public bool Take(in MarkerSighting sighting, HeadsetTime now, in RigidTransform? head, in RigidTransform? watched, bool onlyParts)
        {
            var isAccepted = false;
            if (sighting.Payload == null) return false;
            foreach (var marker in _markers)
            {
                if (!string.Equals(marker.Marker.Payload, sighting.Payload, StringComparison.Ordinal)) continue;
                var belongs = watched.HasValue ? marker.PlaceAt(watched.Value) : (RigidTransform?)null;
                if (!marker.Take(sighting, now, head, belongs)) continue;
                isAccepted = true;
                if (!(watched is RigidTransform place) || marker.IsContradicted || (onlyParts && !marker.IsPart)) continue;
                marker.Compare(place);
                marker.Judge(TurnOfParts(now));
            }
            return isAccepted;
        }

        CommonTurn TurnOfParts(HeadsetTime now)
        {
            var turn = default(CommonTurn);
            foreach (var marker in _markers)
                if (marker.IsPart && marker.Watch.IsKnown && marker.IsFresh(now)) turn = turn.And(marker.Watch.Turn);
            return turn;
        }
    }
}
