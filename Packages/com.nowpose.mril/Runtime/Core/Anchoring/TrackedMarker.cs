using System;
using Nowpose.Anchoring.Fitting;
using Nowpose.Anchoring.Tracking;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>One of the markers of a base, with its sightings.</summary>
    public sealed class TrackedMarker
    {
        /// <summary>Minimum distance at which two sightings of the same code count as two prints. A smaller distance may be noise.</summary>
        const double ApartMetres = 0.05;

        /// <summary>Minimum number of sightings for an estimate. Fewer sightings do not show the scatter.</summary>
        const int MinSightings = 8;

        /// <summary>Minimum share of the poses that agree. If fewer agree, the source may report two poses in turn, of which one is wrong.</summary>
        const double MinInlierShare = 0.75;

        /// <summary>
        /// Maximum share of the poses of a half that agree, if poses alternate. One step of the poses, for example by a correction of the map, leaves
        /// the outliers of the device only in one half.
        /// </summary>
        const double MaxInlierShareOfAlternation = 0.85;

        /// <summary>Maximum age of sightings. Older sightings may show the marker in another position.</summary>
        static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(15);

        readonly AnchoringSettings _settings;
        readonly PoseWindow _window = new PoseWindow();
        HeadsetTime? _judged, _taken, _twice, _alternated;
        SightingFault _counted;
        string _id;
        RigidTransform _pose;
        PoseMean? _mean;

        internal TrackedMarker(BaseMarker marker, AnchoringSettings settings) => (Marker, _settings) = (marker, settings);

        public BaseMarker Marker { get; }

        /// <summary>Number of accepted sightings; a pose that a source reports repeatedly counts once.</summary>
        public long Sightings { get; private set; }

        /// <summary>Number of ignored sightings for each reason.</summary>
        internal SightingFaults Ignored { get; } = new SightingFaults();

        /// <summary>Reason why the newest sighting was ignored; None if it was accepted, and before the first sighting.</summary>
        internal SightingFault Fault { get; private set; }

        /// <summary>Time of the newest accepted sighting; null if there is none.</summary>
        public HeadsetTime? LastSeen => _taken;

        /// <summary>Time of the newest report by a source, accepted or not; null if there is none.</summary>
        public HeadsetTime? LastReported { get; private set; }

        [Obsolete("use LastReported")]
        public HeadsetTime? LastTold => LastReported;

        /// <summary>Whether the marker is part of the lock.</summary>
        public bool IsPart { get; private set; }

        /// <summary>Whether the marker contradicts the other markers.</summary>
        public bool IsContradicted { get; private set; }

        [Obsolete("use IsContradicted")]
        public bool IsDoubted => IsContradicted;

        /// <summary>Whether the deviation of the marker from its expected pose exceeds the tolerance.</summary>
        public bool HasMoved { get; private set; }

        /// <summary>Recent median deviation from the expected position, in metres; null if there are too few sightings.</summary>
        public double? DeviationMetres => Watch.IsKnown ? Watch.Metres : (double?)null;

        /// <summary>Recent median deviation from the expected rotation, in radians; null if there are too few sightings.</summary>
        public double? DeviationRadians => Watch.IsKnown ? Watch.Radians : (double?)null;

        /// <summary>
        /// Root mean square distance of the poses from their mean at the newest estimate, in metres; null before the first estimate.
        /// </summary>
        public double? SpreadMetres => _mean?.SpreadMetres;

        /// <summary>Root mean square angle between the poses and their mean, in radians; null before the first estimate.</summary>
        public double? SpreadRadians => _mean?.SpreadRadians;

        internal DeviationWatch Watch { get; } = new DeviationWatch();

        /// <summary>Estimate at the lock, in the frame of the base; valid only if the marker is part of the lock.</summary>
        internal MarkerEstimate Locked { get; private set; }

        /// <summary>Whether the marker may be added to a lock.</summary>
        internal bool IsOpen => !IsPart && !IsContradicted;

        /// <summary>Whether there are enough sightings, over a sufficient time, for an estimate.</summary>
        internal bool IsReady => _window.Count >= MinSightings && _window.CountOver(_settings.Settle) > 0;

        /// <summary>Returns whether the sightings are recent enough for a comparison with sightings of other markers.</summary>
        internal bool IsRecent(HeadsetTime now) => _taken is HeadsetTime taken && now - taken <= MaxAge;

        /// <summary>Whether the newest estimate shows that the marker is moving.</summary>
        internal bool IsMoving => _mean is PoseMean mean && !mean.IsSteady(_settings.LockErrorMetres, _settings.LockErrorRadians);

        /// <summary>Whether the poses have recently alternated between two. One of the two may be more frequent by chance for a short time.</summary>
        internal bool IsAlternating =>
            _alternated is HeadsetTime alternated && _window.Newest - alternated < TimeSpan.FromTicks(_settings.Settle.Ticks / 2);

        /// <summary>Returns whether an accepted sighting is current.</summary>
        internal bool IsFresh(HeadsetTime now) => _taken is HeadsetTime taken && now - taken <= _settings.Oldest;

        /// <returns>Whether the sighting is new and accepted.</returns>
        /// <param name="belongs">Expected pose; null while no base is locked.</param>
        internal bool Take(in MarkerSighting sighting, HeadsetTime now, in RigidTransform? head, in RigidTransform? belongs)
        {
            LastReported = now;
            // The clock was set back, so the times of the earlier sightings are invalid.
            if (_taken is HeadsetTime last && last - now > SightingGate.Ahead)
            {
                RemoveSightings();
                (_taken, _twice) = (null, null);
            }
            var fault = SightingGate.Judge(sighting, Marker, now, head, _settings);
            if (fault == SightingFault.None) fault = CheckPlace(sighting, now, belongs);
            if (fault != SightingFault.None)
            {
                // A repeated report of the same sighting counts once.
                if (fault != _counted || sighting.LastSeen != _judged) Ignored.Add(fault);
                Fault = _counted = fault;
                _judged = sighting.LastSeen;
                return false;
            }
            if (_taken is HeadsetTime taken && sighting.LastSeen <= taken) return false;
            Fault = SightingFault.None;
            // After a gap the marker may be elsewhere, and the gap does not count as observation time.
            if (_window.Count > 0 && sighting.LastSeen - _window.Newest > _settings.Oldest + _settings.Oldest) RemoveSightings();
            _taken = sighting.LastSeen;
            _id = sighting.Id;
            _pose = sighting.Pose;
            _window.Add(_pose, sighting.LastSeen);
            Sightings++;
            return true;
        }

        /// <summary>Returns the pose in the room frame at which the marker is expected, given the locked base.</summary>
        internal RigidTransform PlaceAt(in RigidTransform locked) => locked * (IsPart ? Locked.Mean : Marker.MarkerInBase);

        /// <summary>Compares the newest sighting with the expected pose.</summary>
        internal void Compare(in RigidTransform locked) => Watch.Add(PlaceAt(locked), _pose, _taken.Value);

        /// <summary>Decides whether the marker has moved.</summary>
        /// <param name="common">Turn that the parts of the lock in view have in common.</param>
        internal void Judge(in CommonTurn common)
        {
            var metres = _settings.ToleranceMetres * (IsPart ? 1 : MarkerAgreement.MetresFactor);
            var radians = _settings.ToleranceRadians * (IsPart ? 1 : MarkerAgreement.AngleFactor);
            var turn = IsPart ? common : Watch.Turn;
            if (Watch.IsBeyond(metres, radians, turn)) HasMoved = true;
            else if (Watch.IsWithin(metres, radians, turn)) HasMoved = false;
        }

        /// <summary>Removes the sightings and their results.</summary>
        internal void RemoveSightings()
        {
            _window.Clear();
            Watch.Clear();
            (_mean, _alternated) = (null, null);
        }

        /// <summary>Resets the marker for a new search.</summary>
        internal void Restart()
        {
            RemoveSightings();
            IsPart = IsContradicted = HasMoved = false;
        }

        /// <summary>Makes the marker a part of the lock.</summary>
        /// <param name="inBase">Estimate of the marker's pose in the frame of the base.</param>
        internal void Join(in MarkerEstimate inBase)
        {
            IsPart = true;
            Locked = inBase;
            Watch.Clear();
        }

        /// <summary>Keeps the place of a part of the lock in the room when a person moves the base.</summary>
        /// <param name="by">New pose of the base relative to its previous pose.</param>
        internal void Nudge(in RigidTransform by) => Locked = Locked.From(by.Inverse);

        /// <summary>Excludes the marker because other markers contradict its configured pose.</summary>
        internal void Exclude()
        {
            IsPart = HasMoved = false;
            IsContradicted = true;
            Watch.Clear();
        }

        /// <summary>Estimates the pose, if there are enough accurate sightings. Allocates a few kB.</summary>
        internal bool TryEstimate(PoseMeanSpace space, out MarkerEstimate estimate)
        {
            estimate = default;
            var count = Math.Max(_window.CountOver(_settings.Settle), MinSightings);
            if (!IsReady) return false;
            _mean = PoseMean.Of(_window, count, space);
            var isMixed = _mean.Value.InlierShare < MinInlierShare && _mean.Value.InlierShareOfBetterHalf < MaxInlierShareOfAlternation;
            if (isMixed && !IsMoving) _alternated = _window.Newest;
            var all = _window.CountSince(_window.Newest - MaxAge);
            if (!IsExact(_mean.Value) && all > count + MinSightings) _mean = PoseMean.Of(_window, all, space);
            var mean = _mean.Value;
            estimate = new MarkerEstimate(
                Marker.MarkerInBase, mean.Pose, mean.ErrorMetres, mean.ErrorRadians, mean.SpreadMetres, mean.SpreadRadians);
            return IsExact(mean);
        }

        bool IsExact(in PoseMean mean) =>
            mean.Inliers >= MinSightings && mean.InlierShare >= MinInlierShare && !IsAlternating
            && mean.ErrorMetres <= _settings.LockErrorMetres && mean.ErrorRadians <= _settings.LockErrorRadians
            && mean.IsSteady(_settings.LockErrorMetres, _settings.LockErrorRadians);

        SightingFault CheckPlace(in MarkerSighting sighting, HeadsetTime now, in RigidTransform? belongs)
        {
            var isOther = _id != null && sighting.Id != _id && IsFresh(now) && _pose.DistanceTo(sighting.Pose) > ApartMetres;
            if (isOther && belongs is RigidTransform place)
            {
                // If there are two prints with the same code, the tracker monitors the print nearer to the expected position.
                if (place.DistanceTo(sighting.Pose) >= place.DistanceTo(_pose)) return SightingFault.TwoPlaces;
                RemoveSightings();
                return SightingFault.None;
            }
            if (isOther)
            {
                _twice = now;
                _window.Clear();
                Watch.Clear();
            }
            return _twice is HeadsetTime twice && now - twice <= _settings.Oldest ? SightingFault.TwoPlaces : SightingFault.None;
        }
    }
}
