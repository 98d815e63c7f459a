using System;
using System.Collections.Generic;
using Nowpose.Anchoring.Tracking;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>
    /// Says where a robot's base is by the markers at it: locks it, hands it to the device to hold, and watches whether it still fits.
    /// </summary>
    /// <remarks>
    /// Belongs to the frame's thread. A frame without a new lock allocates nothing, but for some kB four times a second while markers
    /// are in view that are not part of a lock yet.
    /// </remarks>
    public sealed class BaseTracker
    {
        const int MostMarkers = 32;

        readonly AnchoringSettings _settings;
        readonly EasedPose _shown;
        readonly HeldPlace _place = new HeldPlace();
        readonly LockAttempt _attempt;
        readonly BaseWords _words;
        TrackedMarker[] _markers = Array.Empty<TrackedMarker>();
        BaseAnchorState _state;
        HeadsetTime _now;
        HeadsetTime? _put, _told;
        RelockedFrom? _former;
        RigidTransform? _placed;
        bool _isNews, _isHeldByHand, _wasLost;

        internal BaseTracker(AnchoringSettings settings)
        {
            _settings = settings ?? throw new ArgumentNullException(nameof(settings));
            _shown = new EasedPose(settings.Ease);
            _attempt = new LockAttempt(settings);
            _words = new BaseWords(settings);
        }

        /// <summary>Name of the cell, under which the place is kept; empty for none.</summary>
        public string Cell { get; private set; } = "";

        public IReadOnlyList<TrackedMarker> Markers => _markers;

        public BaseAnchorState State => IsLost ? BaseAnchorState.Lost : _state;

        /// <summary>The state in one line, with what is to be done about it. The same object while it says the same.</summary>
        public string Words => _words.Text;

        /// <summary>Where the base is, in the room frame; null while it is where somebody has put it.</summary>
        /// <remarks>While searching anew, where it was before.</remarks>
        public RigidTransform? Base { get; private set; }

        /// <summary>Where the base is shown, which follows <see cref="Base"/> without jumping.</summary>
        public RigidTransform? Shown => Base.HasValue ? _shown.Pose : null;

        /// <summary>What went into the newest lock; null before one by markers.</summary>
        public LockReport Lock { get; private set; }

        /// <summary>How far the device has moved the base since the newest lock, by correcting its map, metres.</summary>
        public double CorrectedMetres { get; private set; }

        /// <summary>The same of its rotation, radians.</summary>
        public double CorrectedRadians { get; private set; }

        /// <summary>Markers that contradict each other, and by how much; null where none do.</summary>
        public MarkerQuarrel Quarrel => _attempt.Quarrel;

        /// <summary>Whether the device has moved the base since the newest lock by more than a marker may be off.</summary>
        public bool IsCorrected => CorrectedMetres > _settings.ToleranceMetres || CorrectedRadians > _settings.ToleranceRadians;

        /// <summary>Why a source tells of no markers, for the words while they are looked for; null when nothing is wrong.</summary>
        public string SourceProblem { get; set; }

        /// <summary>When anything that is seen, of whatever code, was told last; null while nothing was since the search began.</summary>
        internal HeadsetTime? Told => _told;

        /// <summary>Whether somebody moves a marker by hand, and the base with it.</summary>
        public bool IsBeingPlaced { get; private set; }

        /// <summary>Whether the device holds the place.</summary>
        public bool IsHeld => _place.IsThere;

        /// <summary>The name under which the device keeps the place over restarts; null while it does not.</summary>
        public string KeptAs => _place.KeptAs;

        /// <summary>Why the device does not hold or keep the place, in one line; null when nothing is wrong.</summary>
        public string Problem => _place.Problem;

        /// <summary>How far away the device says that the place is, where that is too far to be followed, metres; else 0.</summary>
        public double ElsewhereMetres => _place.ElsewhereMetres;

        /// <summary>Whether markers are compared with where they belong.</summary>
        bool IsWatching => IsKnown && !_place.IsLost;

        bool IsLost => IsKnown && _place.IsLost;

        bool IsKnown => Base.HasValue
            && (_state == BaseAnchorState.Locked || _state == BaseAnchorState.Restored || _state == BaseAnchorState.Moved);

        /// <summary>Takes these markers from now on.</summary>
        /// <remarks>A lock stays while the cell is the same and the markers that it was made with are among them.</remarks>
        /// <param name="cell">Empty or null not to keep the place.</param>
        /// <param name="markers">Empty for a base that is placed by hand.</param>
        /// <exception cref="InputException">Two of them have the same payload, or there are too many.</exception>
        public void Use(string cell, IReadOnlyList<BaseMarker> markers)
        {
            if (markers == null) throw new ArgumentNullException(nameof(markers));
            SettingRange.RequireCount(markers.Count, 0, MostMarkers, "markers of a base");
            var tracked = new TrackedMarker[markers.Count];
            for (var i = 0; i < tracked.Length; i++)
            {
                var marker = markers[i] ?? throw new ArgumentNullException(nameof(markers));
                for (var j = 0; j < i; j++)
                    if (markers[j].Payload == marker.Payload)
                        throw new InputException(MarkerName.Of(marker.Payload) + " is given twice; each marker of a base needs a payload of its own");
                tracked[i] = Array.Find(_markers, known => known.Marker.IsSameAs(marker)) ?? new TrackedMarker(marker, _settings);
            }
            var isSameCell = Cell == (cell ?? "") && _markers.Length > 0;
            var hasAllParts = Array.TrueForAll(_markers, known => !known.IsPart || Array.IndexOf(tracked, known) >= 0);
            _markers = tracked;
            Cell = cell ?? "";
            if (isSameCell && hasAllParts && tracked.Length > 0)
            {
                if (_state == BaseAnchorState.Moved) JudgeMoved();
                _words.Update(this, _now);
                return;
            }
            if (!isSameCell)
            {
                _place.Release(seekAgain: true);
                LetGo();
            }
            Begin();
            _words.Update(this, _now);
        }

        /// <summary>Lets the markers say anew where the base is; until they have, it stays where it is.</summary>
        /// <remarks>
        /// Where none is in view for long, the former lock is good again. Where there are none at all, what was restored from an earlier
        /// run is taken for right.
        /// </remarks>
        public void Relock()
        {
            if (_markers.Length > 0)
            {
                var former = IsKnown ? new RelockedFrom(_state, _isHeldByHand, _now) : _former;
                Begin();
                _former = former;
            }
            else if (_state == BaseAnchorState.Restored) Confirm();
            _words.Update(this, _now);
        }

        /// <summary>Somebody has put the base elsewhere: a lock is let go of. A search goes on.</summary>
        /// <param name="at">Where, in the room frame: the next lock eases over from there. Null: not known, and it is there at once.</param>
        public void Place(RigidTransform? at = null)
        {
            _place.Release(seekAgain: false);
            LetGo();
            _placed = at;
            _shown.Jump(at);
            (IsBeingPlaced, _isHeldByHand, _former) = (false, false, null);
            if (_state != BaseAnchorState.Searching || _markers.Length == 0) _state = BaseAnchorState.Placed;
            _words.Update(this, _now);
        }

        /// <summary>Lets go of what the device holds; what it keeps stays kept.</summary>
        public void Release()
        {
            _place.Release(seekAgain: true);
            LetGo();
            Begin();
        }

        /// <summary>One frame.</summary>
        /// <param name="sightings">Of all sources; those of other codes are passed over.</param>
        /// <param name="head">Of the viewer in the room frame, x forward; null where it is not known, and what depends on it is not asked.</param>
        /// <param name="anchors">What holds places; null where nothing does.</param>
        internal void Tick(HeadsetTime now, IReadOnlyList<MarkerSighting> sightings, in RigidTransform? head, ISpatialAnchors anchors)
        {
            if (sightings == null) throw new ArgumentNullException(nameof(sightings));
            _now = now;
            FollowPlace(anchors);
            var putDown = IsBeingPlaced;
            for (var i = 0; i < sightings.Count; i++) putDown &= !Take(sightings[i], now, head);
            if (putDown) LockByHand(anchors);
            if (_isNews && !IsBeingPlaced && !_isHeldByHand && !IsLost) Judge(now, anchors);
            if (_former is RelockedFrom former && former.IsOver(now, _markers)) Return(former);
            Ease(now);
            _words.Update(this, now);
        }

        void FollowPlace(ISpatialAnchors anchors)
        {
            var isOpen = _state == BaseAnchorState.Searching || _state == BaseAnchorState.Placed;
            if (!Base.HasValue && isOpen) _place.Seek(anchors, Cell);
            if (IsLost != _wasLost)
            {
                // The map is not the one that the deviations were measured in.
                _wasLost = IsLost;
                foreach (var marker in _markers) marker.ForgetSeen();
            }
            if (IsBeingPlaced || !(_place.Follow(Base) is RigidTransform pose)) return;
            if (!Base.HasValue && isOpen) _state = BaseAnchorState.Restored;
            else if (Base is RigidTransform before && Lock != null) Correct(before, pose);
            Base = pose;
        }

        void Correct(in RigidTransform before, in RigidTransform now)
        {
            if (before.DistanceTo(now) == 0 && before.AngleTo(now) == 0) return;
            CorrectedMetres = Lock.Base.DistanceTo(now);
            CorrectedRadians = Lock.Base.AngleTo(now);
        }

        /// <returns>Whether a hand moves it.</returns>
        bool Take(in MarkerSighting sighting, HeadsetTime now, in RigidTransform? head)
        {
            if (sighting.Tracking == MarkerTracking.Placed) return TakePlaced(sighting, now);
            _told = now;
            if (sighting.Payload == null) return false;
            foreach (var marker in _markers)
            {
                if (!string.Equals(marker.Marker.Payload, sighting.Payload, StringComparison.Ordinal)) continue;
                var belongs = IsWatching ? marker.PlaceAt(Base.Value) : (RigidTransform?)null;
                if (!marker.Take(sighting, now, head, belongs)) continue;
                _isNews = true;
                if (Base is RigidTransform locked && IsWatching && !marker.IsDoubted) marker.Compare(locked);
            }
            return false;
        }

        bool TakePlaced(in MarkerSighting sighting, HeadsetTime now)
        {
            if (!sighting.Pose.IsPose() || (_put is HeadsetTime put && sighting.LastSeen <= put)) return false;
            RigidTransform? inBase = sighting.Payload == null ? RigidTransform.Identity : (RigidTransform?)null;
            foreach (var marker in _markers)
                if (marker.Marker.Payload == sighting.Payload) inBase = marker.Marker.MarkerInBase;
            if (!(inBase is RigidTransform placed)) return false;
            if (!IsBeingPlaced)
            {
                Begin();
                _place.Release(seekAgain: false);
                _state = BaseAnchorState.Searching;
                IsBeingPlaced = true;
            }
            _put = sighting.LastSeen;
            Base = sighting.Pose * placed.Inverse;
            _shown.Jump(Base);
            return true;
        }

        void LockByHand(ISpatialAnchors anchors)
        {
            IsBeingPlaced = false;
            _isHeldByHand = true;
            Take(new LockReport(Base.Value, 0, 0, 0, 0, 0), anchors);
        }

        void Confirm()
        {
            _isHeldByHand = true;
            _state = BaseAnchorState.Locked;
            Lock = new LockReport(Base.Value, 0, 0, 0, 0, 0);
        }

        void Judge(HeadsetTime now, ISpatialAnchors anchors)
        {
            _isNews = false;
            if (IsWatching)
            {
                JudgeMoved();
                if (_state == BaseAnchorState.Moved) return;
            }
            if (_state != BaseAnchorState.Placed && _attempt.Make(now, _markers, Base)) LockByMarkers(anchors);
        }

        void JudgeMoved()
        {
            var hasMoved = false;
            foreach (var marker in _markers) hasMoved |= marker.HasMoved;
            if (hasMoved) _state = BaseAnchorState.Moved;
            else if (_state == BaseAnchorState.Moved) _state = Lock != null ? BaseAnchorState.Locked : BaseAnchorState.Restored;
        }

        // Nothing was in view: what was good before still is. A marker that comes into view says whether.
        void Return(in RelockedFrom former)
        {
            _state = former.State == BaseAnchorState.Moved ? (Lock != null ? BaseAnchorState.Locked : BaseAnchorState.Restored) : former.State;
            _isHeldByHand = former.IsHeldByHand;
            _former = null;
        }

        void LockByMarkers(ISpatialAnchors anchors)
        {
            var fitted = _attempt.Fitted;
            double metres = 0, radians = 0;
            if ((Base ?? _placed) is RigidTransform before) (metres, radians) = (before.DistanceTo(fitted), before.AngleTo(fitted));
            var spread = _attempt.Spread();
            Take(new LockReport(fitted, _attempt.Count, spread.Metres, spread.Radians, metres, radians), anchors);
        }

        void Take(LockReport report, ISpatialAnchors anchors)
        {
            Lock = report;
            (_former, _placed) = (null, null);
            (CorrectedMetres, CorrectedRadians) = (0, 0);
            _state = BaseAnchorState.Locked;
            Base = report.Base;
            _place.Hold(anchors, report.Base, Cell);
        }

        void Ease(HeadsetTime now)
        {
            if (Base is RigidTransform pose) _shown.Follow(pose, now);
            else _shown.Rest(now);
        }

        void Begin()
        {
            foreach (var marker in _markers) marker.Restart();
            _attempt.Reset();
            (_isNews, _isHeldByHand, IsBeingPlaced) = (false, false, false);
            (_former, _told) = (null, null);
            _state = _markers.Length > 0 ? BaseAnchorState.Searching : BaseAnchorState.Placed;
        }

        void LetGo()
        {
            Base = null;
            (Lock, _placed) = (null, null);
            _shown.Jump(null);
            (CorrectedMetres, CorrectedRadians) = (0, 0);
        }
    }
}
