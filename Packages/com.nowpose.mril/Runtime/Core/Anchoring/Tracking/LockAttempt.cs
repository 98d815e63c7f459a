using System;
using System.Collections.Generic;
using Nowpose.Anchoring.Fitting;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Determines the base from all markers with a sufficiently accurate estimate.</summary>
    /// <remarks>Repeats the attempt at intervals while markers are in view that are not yet part of the lock.</remarks>
    sealed class LockAttempt
    {
        /// <summary>Minimum interval between attempts.</summary>
        static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(250);

        /// <summary>Waiting time for markers that come into view a few frames later.</summary>
        static readonly TimeSpan WaitingTime = TimeSpan.FromMilliseconds(80);

        readonly AnchoringSettings _settings;
        readonly PoseMeanSpace _space = new PoseMeanSpace();
        readonly List<MarkerEstimate> _estimates = new List<MarkerEstimate>();
        readonly List<TrackedMarker> _estimated = new List<TrackedMarker>();
        HeadsetTime? _tried, _ready;
        RigidTransform _fitted;

        public LockAttempt(AnchoringSettings settings) => _settings = settings;

        /// <summary>Markers that contradict each other in the newest attempt; null if all agree.</summary>
        public MarkerConflict Conflict { get; private set; }

        public void Reset()
        {
            (_tried, _ready) = (null, null);
            Conflict = null;
        }

        /// <param name="locked">
        /// Locked base; null before the base is locked. If it is given, the markers that are part of the lock are also used.
        /// </param>
        /// <returns>Whether the attempt succeeded. In this case, the markers used become parts of the lock.</returns>
        public bool Make(HeadsetTime now, IReadOnlyList<TrackedMarker> markers, in RigidTransform? locked)
        {
            if (!IsTime(now, markers)) return false;
            Collect(now, markers);
            if (_estimated.Count == 0 || IsWorthWaiting(now, markers)) return false;
            (_tried, _ready) = (now, null);
            if (locked is RigidTransform known) AddParts(markers, known);
            var agreement = MarkerAgreement.Of(_estimates, _settings);
            Conflict = null;
            if (!agreement.IsGood && !TryExclude(agreement)) return false;
            _fitted = agreement.Fitted;
            for (var i = 0; i < _estimated.Count; i++) _estimated[i].Join(_estimates[i].From(_fitted.Inverse));
            return true;
        }

        /// <summary>Returns the lock from the newest successful attempt. Its scatter is the root mean square over the markers used.</summary>
        /// <param name="before">Previous base in the room frame; null if there is none.</param>
        public LockReport Report(in RigidTransform? before)
        {
            double metres = 0, radians = 0;
            foreach (var estimate in _estimates)
            {
                metres += estimate.SpreadMetres * estimate.SpreadMetres / _estimates.Count;
                radians += estimate.SpreadRadians * estimate.SpreadRadians / _estimates.Count;
            }
            var change = before is RigidTransform known ? new MapCorrection(known, _fitted) : default;
            return new LockReport(_fitted, _estimated.Count, Math.Sqrt(metres), Math.Sqrt(radians), change.Metres, change.Radians);
        }

        bool IsTime(HeadsetTime now, IReadOnlyList<TrackedMarker> markers)
        {
            if (_tried is HeadsetTime tried && now >= tried && now - tried < Pause) return false;
            for (var i = 0; i < markers.Count; i++)
                if (markers[i].IsOpen && markers[i].IsReady && markers[i].IsFresh(now)) return true;
            return false;
        }

        void Collect(HeadsetTime now, IReadOnlyList<TrackedMarker> markers)
        {
            _estimates.Clear();
            _estimated.Clear();
            for (var i = 0; i < markers.Count; i++)
            {
                if (!markers[i].IsOpen || !markers[i].IsRecent(now) || !markers[i].TryEstimate(_space, out var estimate)) continue;
                _estimates.Add(estimate);
                _estimated.Add(markers[i]);
            }
            if (_estimated.Count == 0) _tried = now;
        }

        bool IsWorthWaiting(HeadsetTime now, IReadOnlyList<TrackedMarker> markers)
        {
            _ready ??= now;
            if (now - _ready.Value >= WaitingTime) return false;
            for (var i = 0; i < markers.Count; i++)
                if (markers[i].IsOpen && !_estimated.Contains(markers[i]) && markers[i].IsFresh(now)) return true;
            return false;
        }

        void AddParts(IReadOnlyList<TrackedMarker> markers, in RigidTransform known)
        {
            for (var i = 0; i < markers.Count; i++)
            {
                if (!markers[i].IsPart) continue;
                _estimates.Add(markers[i].Locked.From(known));
                _estimated.Add(markers[i]);
            }
        }

        /// <returns>Whether the remaining markers are sufficient.</returns>
        bool TryExclude(in MarkerAgreement agreement)
        {
            var isClear = agreement.Wrong >= 0;
            var wrong = _estimated[isClear ? agreement.Wrong : 0];
            Conflict = new MarkerConflict(wrong.Marker, isClear ? null : _estimated[1].Marker, agreement.Metres, agreement.Radians);
            // The markers of the lock are at the end of the list. If two markers contradict each other, the marker of the lock is kept and the other
            // marker is excluded.
            if (isClear || _estimated[_estimated.Count - 1].IsPart) wrong.Exclude();
            if (!isClear) return false;
            _estimates.RemoveAt(agreement.Wrong);
            _estimated.RemoveAt(agreement.Wrong);
            return true;
        }
    }
}
