using System;
using System.Collections.Generic;
using Nowpose.Anchoring.Tracking;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>
    /// Determines the pose of a robot's base from its markers. It locks the pose, lets the device store it, and monitors whether it is still valid.
    /// </summary>
    /// <remarks>
    /// Use it on the frame loop's thread only. A frame without a new lock normally allocates nothing. While a marker that is not yet part of the
    /// lock is in view, the tracker allocates a few kB four times a second.
    /// </remarks>
    public sealed class BaseTracker
    {
        readonly AnchoringSettings _settings;
        readonly BasePose _pose;
        readonly HeldPlace _place = new HeldPlace();
        readonly LockAttempt _attempt;
        readonly BaseStatusText _words;
        readonly MarkerSet _markers = new MarkerSet();
        readonly HandPlacement _hand = new HandPlacement();
        BaseAnchorState _state;
        HeadsetTime _now;
        RelockedFrom _former;
        ISpatialAnchors _anchors;
        bool _hasNewSightings, _isHeldByHand, _wasUncertain;

        internal BaseTracker(AnchoringSettings settings)
        {
            _settings = settings ?? throw new ArgumentNullException(nameof(settings));
            _pose = new BasePose(settings.Ease);
            _attempt = new LockAttempt(settings);
            _words = new BaseStatusText(settings);
        }

        /// <summary>Name of the cell, under which the device stores the position; empty if the position is not stored.</summary>
        public string Cell { get; private set; } = "";

        public IReadOnlyList<TrackedMarker> Markers => _markers.All;

        public BaseAnchorState State => IsLost ? BaseAnchorState.Lost : Unconfirmed.HasValue ? BaseAnchorState.Restored : _state;

        /// <summary>The state and the required action in one line. Returns the same object as long as the text does not change.</summary>
        public string Words => _words.Text;

        /// <summary>Pose of the base in the room frame; null if neither markers nor the device have determined it.</summary>
        /// <remarks>During a new search, this is the previous pose.</remarks>
        public RigidTransform? Base => _pose.Newest;

        /// <summary>Displayed pose of the base, which follows <see cref="Base"/> without jumps.</summary>
        public RigidTransform? Shown => _pose.Shown;

        /// <summary>Details of the newest lock; null before the first lock, and after the lock was removed.</summary>
        public LockReport Lock => _pose.Lock;

        /// <summary>Distance by which the device has moved the base since the newest lock, by correcting its map, in metres.</summary>
        public double CorrectedMetres => _pose.Correction.Metres;

        /// <summary>Angle by which the device has turned the base since the newest lock, by correcting its map, in radians.</summary>
        public double CorrectedRadians => _pose.Correction.Radians;

        /// <summary>Markers that contradict each other, with their deviation; null if all agree.</summary>
        public MarkerConflict Conflict => _attempt.Conflict;

        [Obsolete("use Conflict")]
        public MarkerConflict Quarrel => Conflict;

        /// <summary>Whether the device has moved the base since the newest lock by more than a marker's tolerance.</summary>
        public bool IsCorrected => _pose.Correction.IsBeyond(_settings.ToleranceMetres, _settings.ToleranceRadians);

        /// <summary>Correction of the map since the lock that is so large that a marker or a person must confirm it; otherwise null.</summary>
        internal MapCorrection? Unconfirmed => _state == BaseAnchorState.Locked ? _pose.Unconfirmed : null;

        /// <summary>Reason why a source reports no markers; null if nothing is wrong. The status text contains this reason during a search.</summary>
        public string SourceProblem { get; set; }

        /// <summary>Time at which a source last reported any code; null if none was reported since the start of the search.</summary>
        internal HeadsetTime? LastReport { get; private set; }

        /// <summary>Whether a person is moving a marker, and the base with it, by hand.</summary>
        public bool IsBeingPlaced { get; private set; }

        /// <inheritdoc cref="HandPlacement.RefusedPayload"/>
        internal string RefusedPayload => _hand.RefusedPayload;

        /// <summary>Returns whether a marker that is placed by hand determines the pose of this base.</summary>
        internal bool Has(string payload) => _markers.PoseInBase(payload) != null;

        /// <summary>Whether the device has an anchor for the position of the base, in any state of the anchor.</summary>
        public bool IsHeld => _place.IsThere;

        /// <summary>Name under which the device stores the position across restarts; null when it is not stored.</summary>
        public string KeptAs => _place.KeptAs;

        /// <summary>Reason why the device does not hold or store the position, in one line; null if nothing is wrong.</summary>
        public string Problem => _place.Problem;

        /// <summary>Distance to the pose that the device reports, in metres, if it is too far away or too much turned to be followed; otherwise 0.</summary>
        public double ElsewhereMetres => _place.Elsewhere?.Metres ?? 0;

        /// <summary>The position that the device holds.</summary>
        internal HeldPlace HeldPlace => _place;

        /// <summary>Whether markers are compared with their expected poses.</summary>
        bool IsWatching => IsKnown && !_place.IsLost;
        bool IsLost => IsKnown && _place.IsLost;
        bool IsLockedByHand => Lock?.Markers == 0;
        bool IsKnown => Base.HasValue && (_state == BaseAnchorState.Locked || _state == BaseAnchorState.Restored || _state == BaseAnchorState.Moved);

        /// <summary>Replaces the cell and the markers.</summary>
        /// <remarks>A lock of the same cell is kept if all its markers are in the list; a lock without markers, if the list is empty.</remarks>
        /// <param name="cell">Null or empty if the position must not be stored.</param>
        /// <param name="markers">Markers at the base; empty for a base that is placed by hand.</param>
        /// <exception cref="InputException">Two markers have the same payload, or there are too many.</exception>
        public void Use(string cell, IReadOnlyList<BaseMarker> markers)
        {
            if (markers == null) throw new ArgumentNullException(nameof(markers));
            var isSameCell = Cell == (cell ?? "");
            if (isSameCell && _markers.Count == 0 && markers.Count == 0) return;
            isSameCell &= _markers.Count > 0;
            var hasAllParts = _markers.Replace(markers, _settings);
            Cell = cell ?? "";
            if (!isSameCell) Release();
            else if (!hasAllParts || markers.Count == 0) Begin();
            else if (_state == BaseAnchorState.Moved) UpdateMoved();
            _words.Update(this, _now);
        }

        /// <summary>Starts a new search with the markers. The base stays in its position until the markers have determined a new position.</summary>
        /// <remarks>
        /// If no marker comes into view for a long time, the previous lock is restored. If no marker can confirm a restored position, because there
        /// are none or the base was locked by hand, the method confirms this position.
        /// </remarks>
        public void Relock()
        {
            if (State == BaseAnchorState.Restored && (_markers.Count == 0 || IsLockedByHand)) Take(LockReport.ByHand(Base.Value), isByHand: true);
            else if (_markers.Count > 0)
            {
                var former = IsKnown ? new RelockedFrom(_state, _now) : _former;
                Begin();
                _former = former;
            }
            _words.Update(this, _now);
        }

        /// <summary>Records that the base was placed elsewhere, and removes the lock. A running search continues.</summary>
        /// <param name="at">Pose in the room from which the next lock is blended in; null if it is unknown: the next lock applies at once.</param>
        public void Place(RigidTransform? at = null)
        {
            _place.Release(seekAgain: false);
            _pose.Clear(at);
            (IsBeingPlaced, _isHeldByHand, _former) = (false, false, null);
            if (_state != BaseAnchorState.Searching || _markers.Count == 0) _state = BaseAnchorState.Placed;
            _words.Update(this, _now);
        }

        /// <summary>Moves a known base by a small amount. The device holds and stores the new pose.</summary>
        /// <remarks>A lock stays, and its markers are monitored. They change it only after <see cref="Relock"/> or <see cref="Resume"/>.</remarks>
        /// <param name="at">New pose in the room frame.</param>
        internal void Nudge(in RigidTransform at)
        {
            if (!IsKnown) Place(at);
            if (!IsKnown) return;
            var (by, isLocked) = (Base.Value.Inverse * at, State == BaseAnchorState.Locked);
            if (isLocked) _markers.Nudge(by);
            else _markers.Restart();
            _pose.Jump(at);
            Take(isLocked && Lock.Markers > 0 ? Lock.Nudged(at, by) : LockReport.ByHand(at), isByHand: true);
            _words.Update(this, _now);
        }

        /// <summary>Releases the position that the device holds, removes the pose of the base, and starts a new search.</summary>
        /// <remarks>A stored position is kept.</remarks>
        public void Release()
        {
            _place.Release(seekAgain: true);
            _pose.Clear(null);
            Begin();
        }

        /// <summary>Records that the app was suspended, for example in standby, after which the origin of the device's poses may be elsewhere.</summary>
        /// <remarks>An anchor moves with the room, so its pose is followed however far it moves. Without one, the markers must determine it again.</remarks>
        internal void Resume(HeadsetTime now)
        {
            _place.Resume(now);
            if (!Base.HasValue || _place.IsConfirmed) return;
            _place.Release(seekAgain: false);
            if (_markers.Count > 0) Begin();
            else if (IsKnown) _state = BaseAnchorState.Restored;
        }

        /// <summary>Processes one frame.</summary>
        /// <param name="sightings">Sightings of all sources; sightings of other codes are ignored.</param>
        /// <param name="head">Viewer's head in the room frame, x forward; null if it is unknown, so that the checks that need it are skipped.</param>
        /// <param name="anchors">Anchors of the device; null if it has none.</param>
        internal void Tick(HeadsetTime now, IReadOnlyList<MarkerSighting> sightings, in RigidTransform? head, ISpatialAnchors anchors)
        {
            (_now, _anchors) = (now, anchors);
            _hand.BeginFrame();
            FollowPlace();
            var isReleased = IsBeingPlaced;
            for (var i = 0; i < sightings.Count; i++) isReleased &= !Take(sightings[i], now, head);
            if (isReleased) Take(LockReport.ByHand(Base.Value), isByHand: true);
            if (_hasNewSightings && !IsBeingPlaced && !IsLost) Judge(now);
            if (_former?.Follow(now, _markers.All) == true) Return(_former);
            _pose.Follow(now);
            _words.Update(this, now);
        }

        void FollowPlace()
        {
            var isOpen = _state == BaseAnchorState.Searching || _state == BaseAnchorState.Placed;
            if (!Base.HasValue && isOpen) _place.Seek(_anchors, Cell);
            if (!IsBeingPlaced && _place.Follow(Base, _now) is RigidTransform pose)
            {
                if (!Base.HasValue && isOpen) _state = BaseAnchorState.Restored;
                if (_place.HasJumped) TakeElsewhere(pose);
                else _pose.Correct(pose);
            }
            // The deviations of the sightings were measured in a map that is no longer valid.
            var isUncertain = IsLost || Unconfirmed.HasValue;
            if (isUncertain != _wasUncertain) _markers.RemoveSightings();
            _wasUncertain = isUncertain;
        }

        // The lock was measured from another origin. The next markers in view confirm the position.
        void TakeElsewhere(in RigidTransform pose)
        {
            _markers.Restart();
            _attempt.Reset();
            _pose.Replace(pose);
            if (IsKnown) (_state, _isHeldByHand) = (BaseAnchorState.Restored, false);
        }

        /// <returns>Whether the marker is being moved by hand.</returns>
        bool Take(in MarkerSighting sighting, HeadsetTime now, in RigidTransform? head)
        {
            if (sighting.Tracking == MarkerTracking.Placed) return TakePlaced(sighting);
            LastReport = now;
            _hasNewSightings |= _markers.Take(sighting, now, head, IsWatching ? Base : null, onlyParts: _isHeldByHand);
            return false;
        }

        bool TakePlaced(in MarkerSighting sighting)
        {
            if (!(_hand.BaseOf(sighting, _markers) is RigidTransform placed)) return false;
            if (!IsBeingPlaced)
            {
                Begin();
                _place.Release(seekAgain: false);
                (_state, IsBeingPlaced) = (BaseAnchorState.Searching, true);
            }
            _pose.Jump(placed);
            return true;
        }

        void Judge(HeadsetTime now)
        {
            _hasNewSightings = false;
            if (IsWatching) UpdateMoved();
            if (_state == BaseAnchorState.Moved || _state == BaseAnchorState.Placed || _isHeldByHand) return;
            if (_attempt.Make(now, _markers.All, Base)) Take(_attempt.Report(Base ?? _pose.From), isByHand: false);
        }

        void UpdateMoved()
        {
            if (_markers.HasMoved) _state = BaseAnchorState.Moved;
            else if (_state == BaseAnchorState.Moved) _state = Lock != null ? BaseAnchorState.Locked : BaseAnchorState.Restored;
            if (_state == BaseAnchorState.Locked && _markers.HasAgreement(_now)) _pose.Confirm();
        }

        // No marker was in view, so the previous state is restored, unless the origin has moved. The next marker in view confirms or refutes it.
        void Return(RelockedFrom former)
        {
            _state = Lock == null ? BaseAnchorState.Restored : former.State == BaseAnchorState.Moved ? BaseAnchorState.Locked : former.State;
            _isHeldByHand = IsLockedByHand;
            _former = null;
        }

        /// <param name="isByHand">Whether no marker changes the lock.</param>
        void Take(LockReport report, bool isByHand)
        {
            _pose.Take(report);
            (_state, _former, _isHeldByHand, IsBeingPlaced) = (BaseAnchorState.Locked, null, isByHand, false);
            _place.Hold(_anchors, report.Base, Cell);
        }

        void Begin()
        {
            _markers.Restart();
            _attempt.Reset();
            (_hasNewSightings, _isHeldByHand, IsBeingPlaced) = (false, false, false);
            (_former, LastReport) = (null, null);
            _state = _markers.Count > 0 ? BaseAnchorState.Searching : BaseAnchorState.Placed;
        }
    }
}
