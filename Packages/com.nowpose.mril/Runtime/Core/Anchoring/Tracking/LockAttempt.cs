using System;
using System.Collections.Generic;
using Nowpose.Anchoring.Fitting;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Finds the base by all markers that are known well enough.</summary>
    /// <remarks>Tries now and then, while some are in view that are not part of a lock yet.</remarks>
    sealed class LockAttempt
    {
        /// <summary>From one try to the next.</summary>
        static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(250);

        /// <summary>For markers that came into view a few frames later.</summary>
        static readonly TimeSpan Patience = TimeSpan.FromMilliseconds(80);

        readonly AnchoringSettings _settings;
        readonly PoseMeanSpace _space = new PoseMeanSpace();
        readonly List<MarkerEstimate> _estimates = new List<MarkerEstimate>();
        readonly List<TrackedMarker> _estimated = new List<TrackedMarker>();
        HeadsetTime? _tried, _ready;

        public LockAttempt(AnchoringSettings settings) => _settings = settings;

        /// <summary>Markers that contradict each other, as of the newest try; null where none do.</summary>
        public MarkerQuarrel Quarrel { get; private set; }

        /// <summary>The base by the newest try that succeeded, in the room frame.</summary>
        public RigidTransform Fitted { get; private set; }

        /// <summary>How many markers went into it.</summary>
        public int Count => _estimated.Count;

        public void Reset()
        {
            (_tried, _ready) = (null, null);
            Quarrel = null;
        }

        /// <param name="locked">The base as it is locked, for what its parts said; null while it is not.</param>
        /// <returns>Whether there is a base to lock. The markers that made it are its parts then.</returns>
        public bool Make(HeadsetTime now, IReadOnlyList<TrackedMarker> markers, in RigidTransform? locked)
        {
            if (!IsTime(now, markers)) return false;
            Collect(now, markers);
            if (_estimated.Count == 0 || IsWorthWaiting(now, markers)) return false;
            (_tried, _ready) = (now, null);
            if (locked is RigidTransform known) AddParts(markers, known);
            var agreement = MarkerAgreement.Of(_estimates, _settings);
            Quarrel = null;
            if (!agreement.IsGood && !LeaveOut(agreement)) return false;
            Fitted = agreement.Fitted;
            for (var i = 0; i < _estimated.Count; i++) _estimated[i].Join(_estimates[i].From(Fitted.Inverse));
            return true;
        }

        /// <summary>Root mean square over the markers of what their poses scatter.</summary>
        public (double Metres, double Radians) Spread()
        {
            double metres = 0, radians = 0;
            foreach (var marker in _estimated)
            {
                metres += marker.SpreadMetres.Value * marker.SpreadMetres.Value / _estimated.Count;
                radians += marker.SpreadRadians.Value * marker.SpreadRadians.Value / _estimated.Count;
            }
            return (Math.Sqrt(metres), Math.Sqrt(radians));
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
            if (now - _ready.Value >= Patience) return false;
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

        /// <returns>Whether the others will do.</returns>
        bool LeaveOut(in MarkerAgreement agreement)
        {
            var isClear = agreement.Wrong >= 0;
            var wrong = _estimated[isClear ? agreement.Wrong : 0];
            Quarrel = new MarkerQuarrel(wrong.Marker, isClear ? null : _estimated[1].Marker, agreement.Metres, agreement.Radians);
            // What a lock was made with stands last, and is not what is doubted where two contradict each other.
            if (isClear || _estimated[_estimated.Count - 1].IsPart) wrong.Doubt();
            if (!isClear) return false;
            _estimates.RemoveAt(agreement.Wrong);
            _estimated.RemoveAt(agreement.Wrong);
            return true;
        }
    }
}
