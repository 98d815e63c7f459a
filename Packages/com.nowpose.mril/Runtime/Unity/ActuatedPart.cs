using System;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Signals;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Moves this object, for example a gripper jaw, a cylinder or a door, between two poses according to a signal.</summary>
    /// <remarks>
    /// A move starts at the stamp of the signal's change and takes the stroke time. The object therefore moves in phase with the real part even if
    /// the message arrived late; see <see cref="ActuatedStroke"/>. The pose for the value 0 is the object's local pose when this component is first
    /// enabled. The object keeps this pose until the first value is known. While the component is disabled, the object stays where it is. If the
    /// object is moved in the meantime, or gets another parent, the pose for the value 0 is computed from its new local pose and its position within
    /// the stroke. While the signal's value is not current or is outside 0 to 1, and while the component is disabled, the
    /// <see cref="PoseAppearance"/> on this object or above it stripes the part. The component does not move an object that another component moves: an
    /// object of the cell, a link that a joint moves, or a finger that a <see cref="VirtualGripper"/> moves.
    /// </remarks>
    [AddComponentMenu("Nowpose/Actuated Part")]
    [DisallowMultipleComponent]
    public sealed class ActuatedPart : MonoBehaviour, ISignalComponent, IShownPart, IFollowsSession
    {
        [SerializeField, Tooltip("The session that receives the signal. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the signal on /signals. Empty: the name of this object.")]
        string _signal = "";

        [SerializeField, Tooltip("Displacement from the position for 0 to the position for 1, in the parent's axes, metres.")]
        Vector3 _wayMetres = Vector3.zero;

        [SerializeField, Tooltip("Rotation from the orientation for 0 to the orientation for 1, about the object's own axes, Euler angles in degrees.")]
        Vector3 _turnDegrees = Vector3.zero;

        [SerializeField, Range(0, 60_000), Tooltip("Time for the whole stroke, ms. 0: the part jumps.")]
        float _strokeMs = 300;

        readonly AppearancesOfParts _appearances = new AppearancesOfParts();
        MrilSession _source;
        Transform _world;
        SignalFollower _follower;
        ActuatedStroke _stroke;
        Vector3 _restPosition;
        Quaternion _restRotation;
        (Component Mover, RobotJoint Joint) _other;
        [NonSerialized] string _conflict, _title, _disabled;

        /// <summary>Name of the signal.</summary>
        public string Signal => _follower != null ? _follower.Name : string.IsNullOrEmpty(_signal) ? name : _signal;

        /// <summary>Position within the stroke in the newest frame, from 0 (start) to 1 (end).</summary>
        public float Share { get; private set; }

        /// <summary>
        /// Reason why the part does not follow the signal, or why the signal's value is not current or is outside the stroke, in one line; null if there is
        /// none.
        /// </summary>
        public string Fault =>
            _conflict ?? (_follower != null ? _follower.Fault : isActiveAndEnabled ? StatusMessages.NoSession
                : (_disabled ??= ObjectMessages.Disabled("actuated part", name)));

        MrilSession IFollowsSession.AssignedSession => _session;

        string ISignalComponent.FaultLabel => _conflict != null ? ObjectMessages.MovedTwice
            : _follower != null && _follower.CurrentFault == null ? ObjectMessages.OutsideStroke : ObjectMessages.SignalNotCurrent;

        string IShownPart.Title => _title;

        string IShownPart.Fault => _conflict;

        bool IShownPart.IsFaultCommon => false;

        ControlTime? IShownPart.FaultSince => null;

        /// <summary>
        /// Sets the fields Session and Signal, and follows the signal from now on. A script can call this method at any time, for example after it has
        /// created the object.
        /// </summary>
        /// <param name="session">The session that receives the signal; null to use the session on this object or a parent.</param>
        /// <param name="signal">Name of the signal; empty for the name of this object.</param>
        public void Follow(MrilSession session, string signal = "")
        {
            var isFollowing = isActiveAndEnabled;
            if (isFollowing) OnDisable();
            _session = session;
            _signal = signal;
            if (isFollowing) OnEnable();
            if (TryGetComponent<PoseAppearance>(out var appearance)) appearance.FindSession();
        }

        void OnEnable()
        {
            TakeRest();
            _stroke = new ActuatedStroke(0, 1, _strokeMs / 1000.0);
            _follower = SignalFollower.Of(this, _session, "actuated part", Signal, Take, restarted: Take);
            _appearances.RefreshIfMoved(this);
            _disabled = null;
            _source = this.SessionOr(_session);
            if (_source == null) return;
            _world = CellPlace.WorldOf(this, _source);
            _source.Movers.Add(this, Show);
            FindOther();
        }

        void OnDisable()
        {
            if (_follower == null) return;
            _follower.Leave();
            _follower = null;
            _source.Movers.Remove(this);
            if (_conflict != null) SetOther(default);
            // An object that is switched off may get another place, or be copied, before it is switched on again.
            else if (!gameObject.activeInHierarchy) Move(0);
            _source = null;
        }

        void OnTransformParentChanged()
        {
            TakeRest();
            _appearances.Refresh(this);
            if (!this.IsBelowAnotherSession(_session, _source)) return;
            OnDisable();
            OnEnable();
        }

        void Show(DisplayFrame frame)
        {
            _follower.Update(frame);
            FindOther();
            if (_conflict == null && frame.DisplayTime is ControlTime displayTime) Move((float)_stroke.At(displayTime));
        }

        // Another component may start or stop to move the object at any time, for example when the rig is bound to its robot.
        void FindOther()
        {
            var other = OtherMover.Of(this);
            // Unity's == is not used, because a destroyed component equals null.
            if (!ReferenceEquals(other.Mover, _other.Mover) || other.Joint != _other.Joint) SetOther(other);
        }

        void SetOther((Component Mover, RobotJoint Joint) other)
        {
            var isListed = _conflict != null;
            _other = other;
            _conflict = OtherMover.Conflict(other.Mover, other.Joint);
            if (_conflict != null)
            {
                Share = 0;
                _title = "actuated part " + name;
                ConsoleLog.Fail(this, ComponentMessages.Of("actuated part", name, _conflict));
            }
            else TakeRest();
            if (isListed == (_conflict != null)) return;
            if (isListed) _source.Parts.Remove(this);
            else _source.Parts.Add(this);
        }

        // After a step of the control clock, the time of the change is unknown, so the part jumps to the end of its move.
        void Take(SignalTrack signal)
        {
            if (!signal.Since.HasValue) _stroke.Forget();
            _stroke.Change(signal.Value, signal.Since ?? default);
            _follower.Problem = ActuatedStroke.Includes(signal.Value) ? null : ObjectMessages.ValueOutsideStroke(signal.Value);
        }

        // The part keeps its share of the stroke below a new parent.
        void TakeRest()
        {
            _restPosition = transform.localPosition - Way(Share);
            _restRotation = transform.localRotation * Quaternion.Inverse(Quaternion.Euler(Share * _turnDegrees));
        }

        // Returns the displacement at a share of the stroke, in the units of the parent.
        Vector3 Way(float share) => _world == null ? share * _wayMetres : (share * _wayMetres).InUnitsOfParent(transform, _world);

        void Move(float share)
        {
            Share = share;
            transform.localPosition = _restPosition + Way(share);
            transform.localRotation = _restRotation * Quaternion.Euler(share * _turnDegrees);
        }
    }
}
