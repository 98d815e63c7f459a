using System;
using Nowpose.Anchoring.Fitting;
using Nowpose.Anchoring.Tracking;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>One of a base's markers, and what was seen of it.</summary>
    public sealed class TrackedMarker
    {
        /// <summary>Another one of the same code is at least this far away: the two are no noise.</summary>
        const double ApartMetres = 0.05;

        /// <summary>Fewer say nothing of how much they scatter.</summary>
        const int Least = 8;

        /// <summary>What was seen before may be of another place.</summary>
        static readonly TimeSpan Longest = TimeSpan.FromSeconds(15);

        readonly AnchoringSettings _settings;
        readonly PoseWindow _window = new PoseWindow();
        HeadsetTime? _judged, _taken, _twice;
        SightingFault _counted;
        string _id;
        RigidTransform _pose;
        PoseMean? _mean;

        internal TrackedMarker(BaseMarker marker, AnchoringSettings settings)
        {
            Marker = marker;
            _settings = settings;
        }

        public BaseMarker Marker { get; }

        /// <summary>Sightings that counted; a pose that a source goes on telling counts once.</summary>
        public long Sightings { get; private set; }

        /// <summary>Those that did not.</summary>
        internal SightingFaults Ignored { get; } = new SightingFaults();

        /// <summary>Why the newest sighting did not count; None where it did, or where there is none.</summary>
        internal SightingFault Fault { get; private set; }

        /// <summary>When it was seen last in a way that counts; null for never.</summary>
        public HeadsetTime? LastSeen => _taken;

        /// <summary>When a source told anything of it last; null for never.</summary>
        public HeadsetTime? LastTold { get; private set; }

        /// <summary>Whether the lock was made with it.</summary>
        public bool IsPart { get; private set; }

        /// <summary>Whether the other markers say that it is not where it was measured to be.</summary>
        public bool IsDoubted { get; private set; }

        /// <summary>Whether it is farther from where it belongs than allowed.</summary>
        public bool HasMoved { get; private set; }

        /// <summary>How far it is lately from where it belongs, metres: a median. Null while too little is seen.</summary>
        public double? DeviationMetres => Watch.IsKnown ? Watch.Metres : (double?)null;

        /// <summary>By how much it is turned against how it belongs, radians.</summary>
        public double? DeviationRadians => Watch.IsKnown ? Watch.Radians : (double?)null;

        /// <summary>Root mean square distance of its poses from their mean when this was worked out last, metres; null before.</summary>
        public double? SpreadMetres => _mean?.SpreadMetres;

        /// <summary>Root mean square angle of its poses to their mean, radians.</summary>
        public double? SpreadRadians => _mean?.SpreadRadians;

        internal DeviationWatch Watch { get; } = new DeviationWatch();

        /// <summary>As it was seen when the lock was made with it, in the frame of the base; only of a part.</summary>
        internal MarkerEstimate Locked { get; private set; }

        internal RigidTransform Pose => _pose;

        /// <summary>Whether a lock may be made better by it.</summary>
        internal bool IsOpen => !IsPart && !IsDoubted;

        /// <summary>Whether it was seen often and long enough for an estimate.</summary>
        internal bool IsReady => _window.Count >= Least && _window.CountOver(_settings.Settle) > 0;

        /// <summary>Whether what was seen of it is new enough to be compared with what is seen of others.</summary>
        internal bool IsRecent(HeadsetTime now) => _taken is HeadsetTime taken && now - taken <= Longest;

        /// <summary>Whether it goes somewhere, as far as that is known.</summary>
        internal bool IsMoving => _mean is PoseMean mean && !mean.IsSteady(_settings.LockErrorMetres, _settings.LockErrorRadians);

        /// <summary>Whether it was seen lately in a way that counts.</summary>
        internal bool IsFresh(HeadsetTime now) => _taken is HeadsetTime taken && now - taken <= _settings.Oldest;

        /// <returns>Whether it is news that counts.</returns>
        /// <param name="belongs">Where it belongs; null while no base is locked.</param>
        internal bool Take(in MarkerSighting sighting, HeadsetTime now, in RigidTransform? head, in RigidTransform? belongs)
        {
            LastTold = now;
            // The clock has gone back.
            if (_taken is HeadsetTime last && last - now > SightingGate.Ahead)
            {
                ForgetSeen();
                (_taken, _twice) = (null, null);
            }
            var fault = SightingGate.Judge(sighting, Marker, now, head, _settings);
            if (fault == SightingFault.None) fault = JudgePlace(sighting, now, belongs);
            if (fault != SightingFault.None)
            {
                // The same news told again is no other sighting.
                if (fault != _counted || sighting.LastSeen != _judged) Ignored.Add(fault);
                Fault = _counted = fault;
                _judged = sighting.LastSeen;
                return false;
            }
            if (_taken is HeadsetTime taken && sighting.LastSeen <= taken) return false;
            Fault = SightingFault.None;
            // Meanwhile it may have gone elsewhere: what was seen before says nothing of it, and is no time of looking at it.
            if (_window.Count > 0 && sighting.LastSeen - _window.Newest > _settings.Oldest + _settings.Oldest) ForgetSeen();
            _taken = sighting.LastSeen;
            _id = sighting.Id;
            _pose = sighting.Pose;
            _window.Add(_pose, sighting.LastSeen);
            Sightings++;
            return true;
        }

        /// <summary>Where it belongs.</summary>
        internal RigidTransform PlaceAt(in RigidTransform locked) => locked * (IsPart ? Locked.Mean : Marker.MarkerInBase);

        /// <summary>Compares what was seen of it last with where it belongs.</summary>
        internal void Compare(in RigidTransform locked)
        {
            Watch.Add(PlaceAt(locked), _pose, _taken.Value);
            var metres = _settings.ToleranceMetres * (IsPart ? 1 : MarkerAgreement.MetresFactor);
            var radians = _settings.ToleranceRadians * (IsPart ? 1 : MarkerAgreement.AngleFactor);
            if (Watch.IsBeyond(metres, radians)) HasMoved = true;
            else if (Watch.IsWithin(metres, radians)) HasMoved = false;
        }

        /// <summary>Forgets where it was seen.</summary>
        internal void ForgetSeen()
        {
            _window.Clear();
            Watch.Clear();
            _mean = null;
        }

        /// <summary>Forgets what it was, and begins anew.</summary>
        internal void Restart()
        {
            ForgetSeen();
            IsPart = IsDoubted = HasMoved = false;
        }

        /// <summary>A lock is made with it.</summary>
        /// <param name="inBase">As it was seen, in the frame of the base.</param>
        internal void Join(in MarkerEstimate inBase)
        {
            IsPart = true;
            Locked = inBase;
            Watch.Clear();
        }

        /// <summary>Other markers have shown that it is not where it was measured to be.</summary>
        internal void Doubt()
        {
            IsPart = HasMoved = false;
            IsDoubted = true;
            Watch.Clear();
        }

        /// <summary>Where it is, once that is known well enough. Allocates some kB.</summary>
        internal bool TryEstimate(PoseMeanSpace space, out MarkerEstimate estimate)
        {
            estimate = default;
            var count = Math.Max(_window.CountOver(_settings.Settle), Least);
            if (!IsReady) return false;
            _mean = PoseMean.Of(_window, count, space);
            var all = _window.CountSince(_window.Newest - Longest);
            if (!IsExact(_mean.Value) && all > count + Least) _mean = PoseMean.Of(_window, all, space);
            var mean = _mean.Value;
            estimate = new MarkerEstimate(Marker.MarkerInBase, mean.Pose, mean.ErrorMetres, mean.ErrorRadians);
            return IsExact(mean);
        }

        bool IsExact(in PoseMean mean) =>
            mean.Inliers >= Least && mean.ErrorMetres <= _settings.LockErrorMetres && mean.ErrorRadians <= _settings.LockErrorRadians
            && mean.IsSteady(_settings.LockErrorMetres, _settings.LockErrorRadians);

        SightingFault JudgePlace(in MarkerSighting sighting, HeadsetTime now, in RigidTransform? belongs)
        {
            var isOther = _id != null && sighting.Id != _id && IsFresh(now) && _pose.DistanceTo(sighting.Pose) > ApartMetres;
            if (isOther && belongs is RigidTransform place)
            {
                // Of two prints the one at the robot goes on being watched.
                if (place.DistanceTo(sighting.Pose) >= place.DistanceTo(_pose)) return SightingFault.TwoPlaces;
                ForgetSeen();
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
