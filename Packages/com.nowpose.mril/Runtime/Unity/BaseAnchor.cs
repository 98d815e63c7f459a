using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Unity.Anchoring;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Robot;
using Nowpose.Unity.Session;
using Nowpose.Unity.Status;
using UnityEngine;
using UnityEngine.Serialization;

namespace Nowpose.Unity
{
    /// <summary>Places the robot's base frame in the room. All objects that show the robot must be children of this object.</summary>
    /// <remarks>
    /// This object keeps its initial pose until the pose is determined from markers that are fixed to the base. The component searches for marker
    /// sources and spatial anchors below the session's object; without a session, below the root object of the hierarchy.
    /// </remarks>
    [AddComponentMenu("Nowpose/Base Anchor")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder - 1)]
    [DisallowMultipleComponent]
    public sealed class BaseAnchor : MonoBehaviour
    {
        const float GizmoMetres = 0.2f, MarkerGizmoMetres = 0.05f;

        // Above rounding errors of the scales and rotations of the parents.
        const float ScaleTolerance = 1e-4f;

        [SerializeField, Tooltip("Name of the robot cell. The headset stores the base's pose under this name. Empty: the pose is not stored.")]
        string _cell = "";

        [SerializeField, Tooltip("Codes fixed to the robot's base, with their poses. Empty: the base stays where it is placed by hand.")]
        List<AnchorMarker> _markers = new List<AnchorMarker>();

        [SerializeField, Range(100, 60_000), Tooltip("Minimum time from the first to the last pose of a marker before the base is locked, ms. "
            + "Default 1850: long enough to average out most of the tracker's noise, while the user waits less than 2 s.")]
        float _settleMs = 1850;

        [FormerlySerializedAs("_oldestMs")]
        [SerializeField, Range(20, 10_000), Tooltip("Maximum age of a marker's pose, ms. Older poses are ignored. Default 2000: trackers continue "
            + "to report old poses, and 99 % of a HoloLens 2's poses of a code in view are younger than 2 s.")]
        float _maxAgeMs = 2000;

        [FormerlySerializedAs("_farthestMetres")]
        [SerializeField, Range(0.1f, 20), Tooltip("Maximum distance from the head to a marker in metres. Markers farther away are ignored. "
            + "Default 2.5: the error of a pose grows with the distance.")]
        float _maxDistanceMetres = 2.5f;

        [FormerlySerializedAs("_mostObliqueDegrees")]
        [SerializeField, Range(10, 89), Tooltip("Maximum viewing angle in degrees, measured between the marker's normal and the line to the "
            + "head. Markers seen at a larger angle are ignored. Default 60: at this angle, a code appears half as wide, and its measured "
            + "angle becomes uncertain.")]
        float _maxViewingAngleDegrees = 60;

        [SerializeField, Range(0.0001f, 0.1f), Tooltip("Maximum position error for locking, metres, estimated from the scatter of a marker's "
            + "poses. Default 0.001: with a scatter of 10 mm this takes 100 sightings.")]
        float _lockErrorMetres = 0.001f;

        [SerializeField, Range(0.01f, 10), Tooltip("Maximum rotation error for locking, degrees, estimated from the scatter of a marker's poses. "
            + "Default 0.25: 2.6 mm at 0.6 m from the base if it has one marker.")]
        float _lockErrorDegrees = 0.25f;

        [SerializeField, Range(0.001f, 1), Tooltip("Maximum distance of a marker from its expected position in metres. A marker beyond it counts "
            + "as moved. Default 0.005: reliable with a noise of 2 mm.")]
        float _toleranceMetres = 0.005f;

        [SerializeField, Range(0.1f, 45), Tooltip("Maximum rotation of a marker from its expected orientation in degrees. A marker beyond it "
            + "counts as moved. Default 0.5: 5 mm at 0.6 m from the base.")]
        float _toleranceDegrees = 0.5f;

        [SerializeField, Range(0, 10_000), Tooltip("Duration of the transition to a new base pose, ms. 0: the base jumps. Default 800: the "
            + "motion is visible but short.")]
        float _easeMs = 800;

        readonly Listeners<Action> _moved = new Listeners<Action>(), _stateChanged = new Listeners<Action>();
        readonly AnchorSources _sources = new AnchorSources();
        MrilSession _session;
        readonly AnchorLog _log = new AnchorLog();
        BaseAnchorState _state;
        [NonSerialized] string _words = "", _fault;
        // After a recompilation of scripts in play mode, the fields apply again, because the tracker with the markers of the script is lost.
        [NonSerialized] bool _loggedScale, _isGiven;
        (Vector3 Position, Quaternion Rotation) _own;

        /// <summary>Raised when <see cref="Place"/> or <see cref="Nudge"/> moves the anchor.</summary>
        public event Action Moved { add => _moved.Add(value); remove => _moved.Remove(value); }

        /// <summary>Raised when <see cref="State"/> or <see cref="Words"/> changes, except when the object is switched off.</summary>
        public event Action StateChanged { add => _stateChanged.Add(value); remove => _stateChanged.Remove(value); }

        /// <summary>Name of the robot cell, under which the headset saves the pose. If the name is empty, the pose is not saved.</summary>
        public string Cell => Tracker?.Cell ?? _cell;

        /// <summary>State of the base's pose: for example placed by hand, searching for markers, or locked by markers.</summary>
        /// <remarks>
        /// While the fields are invalid or the component is not active and enabled, no marker can determine or check the pose, so the state is
        /// searching. A base that was placed by hand needs no check, and stays placed.
        /// </remarks>
        public BaseAnchorState State => Problem != null ? BaseAnchorState.Searching : Tracker?.State ?? BaseAnchorState.Placed;

        /// <summary>Describes the state, and what the user must do, in one line.</summary>
        public string Words => Problem ?? Tracker?.Words ?? "placed by hand";

        /// <summary>Reason why this component neither determines nor checks the pose, in one line; null if it does or need not.</summary>
        internal string Problem => _fault ?? (NeedsChecks && !isActiveAndEnabled ? BaseMessages.Disabled : null);

        bool NeedsChecks => Tracker == null ? _markers.Count > 0 : Tracker.State != BaseAnchorState.Placed;

        /// <summary>Whether the base has markers, which place it at the real robot, but another scale than the real robot.</summary>
        internal bool IsScaledWithMarkers =>
            (Tracker?.Markers.Count ?? _markers.Count) > 0 && (transform.lossyScale - Vector3.one).magnitude > ScaleTolerance;

        /// <summary>
        /// Tracker that determines the base from the markers; provides the state, the lock and each marker. Null before this component is first
        /// enabled, placed or given markers, and while its fields are invalid.
        /// </summary>
        public BaseTracker Tracker { get; private set; }

        /// <summary>Replaces the cell and the markers that were entered in the Inspector.</summary>
        /// <remarks>The base stays locked if the cell is the same and the new markers include the markers that locked it.</remarks>
        /// <param name="cell">Name of the cell, under which the headset saves the pose. If it is empty or null, the pose is not saved.</param>
        /// <param name="markers">The markers fixed to the base; empty if the base is placed by hand.</param>
        /// <exception cref="InputException">Two markers have the same payload, or there are too many markers.</exception>
        public void Use(string cell, IReadOnlyList<BaseMarker> markers)
        {
            if (markers == null) throw new ArgumentNullException(nameof(markers));
            Track(cell, markers);
            if (!_isGiven) _own = (transform.localPosition, transform.localRotation);
            _isGiven = true;
            Notify();
        }

        /// <summary>Undoes <see cref="Use"/>: the cell and the markers of the fields apply, from the pose that this object had before.</summary>
        internal void UseFields()
        {
            if (!_isGiven) return;
            _isGiven = false;
            (transform.localPosition, transform.localRotation) = _own;
            Tracker?.Release();
            TrackFields();
            Notify();
        }

        /// <summary>
        /// Starts a new search for the base by its markers. Until the search succeeds, the base keeps its pose and its appearance shows that it
        /// is not locked.
        /// </summary>
        /// <remarks>If no marker can confirm a restored pose, because there is none or the base was locked by hand, this confirms it.</remarks>
        public void Relock()
        {
            Tracker?.Relock();
            Notify();
        }

        /// <summary>Moves the base frame to a pose in the world, without a transition. Releases a lock; a running search continues.</summary>
        /// <param name="position">Position of the base frame's origin, in metres.</param>
        /// <param name="rotation">Rotation of the base frame in Unity's axes (x right, y up, z forward). Any length except zero is allowed.</param>
        /// <exception cref="ArgumentException">A value is not finite, or the rotation is zero.</exception>
        public void Place(Vector3 position, Quaternion rotation)
        {
            MoveTo(position, rotation);
            Tracker?.Place(UnityPoses.ToRoom(transform.position, transform.rotation));
            _moved.Raise(this);
            Notify();
        }

        /// <summary>Shifts the base frame along its own axes and rotates it about its own vertical axis.</summary>
        /// <remarks>A lock stays, and the device stores it. No marker changes it until <see cref="Relock"/> or a new search after standby.</remarks>
        /// <param name="metres">Offset to the robot's right (x), up (y) and forward (z), in metres.</param>
        /// <param name="degreesAboutUp">Rotation in degrees; positive is clockwise as seen from above.</param>
        /// <exception cref="ArgumentException">A value is not finite.</exception>
        public void Nudge(Vector3 metres, float degreesAboutUp)
        {
            if (!float.IsFinite(degreesAboutUp)) throw new ArgumentException(BaseMessages.AngleNotFinite(degreesAboutUp), nameof(degreesAboutUp));
            // During a transition, this object has not yet reached the pose of the base.
            var from = Tracker?.Base is Kinematics.RigidTransform at ? UnityPoses.ToWorld(at) : new Pose(transform.position, transform.rotation);
            MoveTo(from.position + from.rotation * metres, from.rotation * Quaternion.AngleAxis(degreesAboutUp, Vector3.up));
            Tracker?.Nudge(UnityPoses.ToRoom(transform.position, transform.rotation));
            _moved.Raise(this);
            Notify();
        }

        void MoveTo(Vector3 position, Quaternion rotation)
        {
            var length = Mathf.Sqrt(Quaternion.Dot(rotation, rotation));
            if (!float.IsFinite(position.x + position.y + position.z)) throw new ArgumentException(BaseMessages.PositionNotFinite(position), nameof(position));
            if (!(length > 0) || float.IsInfinity(length)) throw new ArgumentException(BaseMessages.RotationInvalid(rotation), nameof(rotation));
            transform.SetPositionAndRotation(position, new Quaternion(rotation.x / length, rotation.y / length, rotation.z / length, rotation.w / length));
            if (Tracker == null) TrackFields(); // Otherwise, the device would restore its stored pose instead when this component is first enabled.
        }

        void OnEnable()
        {
            _session = this.SessionOr(null);
            _sources.Forget();
            if (!_isGiven) TrackFields();
            Notify();
        }

        // While Unity switches an object off, or ends the scene, listeners must not switch objects on or off.
        void OnDisable()
        {
            if (gameObject.activeInHierarchy) Notify();
        }

        void OnDestroy() => Tracker?.Release();

        void OnApplicationPause(bool isPaused)
        {
            if (!isPaused) Tracker?.Resume(_session.ClockOrDevices().Now);
        }

        void LateUpdate()
        {
            _sources.Find(_session != null ? _session.transform : transform.root);
            if (Tracker == null || (_sources.IsEmpty && Tracker.Markers.Count == 0)) return;
            ReportScale();
            var head = Viewer.Head;
            Tracker.SourceProblem = _sources.Problem;
            Tracker.Tick(
                _session.ClockOrDevices().Now, _sources.ReadFor(Tracker),
                head != null ? UnityPoses.ToRoom(head.position, head.rotation) : (Kinematics.RigidTransform?)null, _sources.Anchors);
            if (Tracker.Shown is Kinematics.RigidTransform shown)
            {
                var place = UnityPoses.ToWorld(shown);
                transform.SetPositionAndRotation(place.position, place.rotation);
                _sources.Rest(place, Tracker);
            }
            Notify();
        }

        void Notify()
        {
            var (state, words) = (State, Words);
            if (state == _state && ReferenceEquals(words, _words)) return;
            (_state, _words) = (state, words);
            _log.Log(this, Tracker, state, words, isQuiet: Problem != null);
            _stateChanged.Raise(this);
        }

        void ReportScale()
        {
            var wasScaled = _loggedScale;
            _loggedScale = IsScaledWithMarkers;
            if (!wasScaled && _loggedScale) ConsoleLog.Warn(this, ComponentMessages.Of("base anchor", name, BaseMessages.Scaled(transform.lossyScale)));
        }

        void TrackFields()
        {
            try
            {
                Track(_cell, _markers.ConvertAll(marker => marker.Read()));
            }
            catch (InputException fault)
            {
                Fail(fault);
            }
        }

        void Track(string cell, IReadOnlyList<BaseMarker> markers)
        {
            Tracker ??= NewTracker();
            if (Tracker == null) return;
            Tracker.Use(cell, markers);
            _fault = null;
        }

        BaseTracker NewTracker()
        {
            try
            {
                return new BaseTracker(new AnchoringSettings(
                    _settleMs, _maxAgeMs, _maxDistanceMetres, _maxViewingAngleDegrees, _lockErrorMetres, _lockErrorDegrees,
                    _toleranceMetres, _toleranceDegrees, _easeMs));
            }
            catch (InputException fault)
            {
                Fail(fault);
                return null;
            }
        }

        void Fail(InputException fault)
        {
            Tracker?.Release();
            Tracker = null;
            if (_fault == fault.Message) return;
            _fault = fault.Message;
            ConsoleLog.Fail(this, ComponentMessages.Of("base anchor", name, _fault));
        }

        void OnDrawGizmosSelected()
        {
            FrameGizmo.Draw(transform, GizmoMetres);
            foreach (var marker in _markers)
                FrameGizmo.DrawCode(transform, marker.Place, marker.SizeMetres > 0 ? marker.SizeMetres : MarkerGizmoMetres);
        }
    }
}
