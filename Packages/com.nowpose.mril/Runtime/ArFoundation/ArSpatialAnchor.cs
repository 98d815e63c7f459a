using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using UnityEngine;
using UnityEngine.XR.ARFoundation;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>One anchor of AR Foundation, either new or loaded from the store.</summary>
    sealed class ArSpatialAnchor : ISpatialAnchor
    {
        /// <summary>Timeout for the creation of an anchor. The device takes some seconds to scan a new room.</summary>
        const float CreationTimeoutSeconds = 10;

        /// <summary>
        /// A pose at the session's origin counts as measured, and not as the device's default, only if it is at most this far from the last pose.
        /// </summary>
        const float NearMetres = 0.1f;

        readonly ArSpatialAnchors _owner;
        readonly AnchorCreation _creation;
        readonly TrackableId _loaded;
        readonly AnchorKeeping _keeping;
        readonly double _since;
        ARAnchor _anchor;
        XRAnchorSubsystem _subsystem;
        SpatialAnchorState _state;
        string _problem;
        bool _wasThere;

        /// <summary>Constructs a new anchor; the device creates it later.</summary>
        public ArSpatialAnchor(ArSpatialAnchors owner, Pose world, in RigidTransform room)
            : this(owner)
        {
            _creation = new AnchorCreation(world);
            Pose = room;
        }

        /// <summary>Constructs a loaded anchor; the anchor manager lists it later.</summary>
        public ArSpatialAnchor(ArSpatialAnchors owner, TrackableId id, string keptAs)
            : this(owner)
        {
            _loaded = id;
            _keeping.KeptAs = keptAs;
        }

        ArSpatialAnchor(ArSpatialAnchors owner)
        {
            _owner = owner;
            _keeping = new AnchorKeeping(owner, this);
            _since = Time.unscaledTimeAsDouble;
        }

        // While the owner is switched off, the state that it updated last may no longer be true.
        public SpatialAnchorState State => _state == SpatialAnchorState.Tracking && !_owner.IsOn ? SpatialAnchorState.Lost : _state;
        public RigidTransform? Pose { get; private set; }
        public string KeptAs => _keeping.KeptAs;
        public string Problem => _state != SpatialAnchorState.Failed && !_owner.IsOn ? DeviceMessages.AnchorsOff : _problem;

        public void Keep(string name)
        {
            if (_state == SpatialAnchorState.Failed) return;
            _keeping.Keep(name);
            _problem = _keeping.Problem;
        }

        public void Dispose()
        {
            // The device's anchor is destroyed only if no other object uses it.
            var isLast = _owner.Remove(this);
            if (_state == SpatialAnchorState.Failed) return;
            if (!isLast) _anchor = null;
            End("it was released");
        }

        public bool IsOf(ArSpatialAnchor other) => _anchor != null && ReferenceEquals(_anchor, other._anchor);

        public void RemoveName(string name) => _keeping.RemoveName(name);

        /// <summary>Updates state and pose from the device. Call once per frame.</summary>
        public void Follow()
        {
            if (_state == SpatialAnchorState.Failed) return;
            if (_anchor == null && !_wasThere) Begin();
            if (_anchor == null)
            {
                if (_wasThere) End(DeviceMessages.AnchorRemoved);
                else if (!IsLoaded && Time.unscaledTimeAsDouble - _since > CreationTimeoutSeconds)
                    End(_owner.Problem ?? _creation.Problem ?? DeviceMessages.NoAnchors);
                return;
            }
            _wasThere = true;
            Track();
        }

        bool IsLoaded => _creation == null;

        void Begin()
        {
            if (!_owner.IsRunning) return;
            if (!IsLoaded) _creation.Follow(_owner.Manager.subsystem, _owner.Trackables);
            var id = IsLoaded ? _loaded : _creation.Id;
            if (id != TrackableId.invalidId) _owner.Manager.trackables.TryGetTrackable(id, out _anchor);
        }

        void Track()
        {
            var place = _anchor.transform;
            if (_owner.IsRunning && (_subsystem ??= _owner.Manager.subsystem) != _owner.Manager.subsystem)
            {
                End(DeviceMessages.AnchorOfEarlierSession);
                return;
            }
            // Without its subsystem, the anchor keeps its last state.
            if (!_owner.IsRunning || _anchor.trackingState != TrackingState.Tracking || (_owner.IsSessionOrigin(place.position) && !IsNear(place.position)))
            {
                if (_state == SpatialAnchorState.Tracking || IsLoaded) _state = SpatialAnchorState.Lost;
                return;
            }
            _state = SpatialAnchorState.Tracking;
            Pose = UnityPoses.ToRoom(place.position, place.rotation);
            _keeping.Follow(_anchor.trackableId);
            _problem = _keeping.Problem;
        }

        bool IsNear(Vector3 place) => Pose is RigidTransform last && Vector3.Distance(UnityPoses.ToWorld(last).position, place) < NearMetres;

        void End(string problem)
        {
            if (_anchor != null) Object.Destroy(_anchor.gameObject);
            else if (!_wasThere) _creation?.Release();
            _anchor = null;
            _state = SpatialAnchorState.Failed;
            _problem = problem;
        }
    }
}
