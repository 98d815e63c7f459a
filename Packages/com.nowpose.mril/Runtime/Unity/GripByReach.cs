using System;
using Nowpose.Frames;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Makes a virtual gripper carry the object within its reach while a signal is on, for cells in which no source reports the held object.
    /// </summary>
    /// <remarks>
    /// The gripper can carry the Tracked Objects and Stationary Objects of the same session for which Can Be Gripped is on. The poses at the stamp of the
    /// signal's change determine which object is within reach, so the result is the same on all headsets. A parent that a source reports for the
    /// object has priority.
    /// </remarks>
    [AddComponentMenu("Nowpose/Grip by Reach")]
    [DisallowMultipleComponent]
    public sealed class GripByReach : MonoBehaviour, IShownPart
    {
        [SerializeField, Tooltip("The rig whose robot carries the gripper. Empty: the rig on a parent.")]
        RobotRig _rig = null;

        [SerializeField, Tooltip("Name of the signal on /signals that is on (0.5 or more) while the gripper is closed. Empty: the name of this object.")]
        string _signal = "";

        [SerializeField, Tooltip("Name of the robot's link whose origin is the gripping point. Empty: the tool, or the flange of a robot without one.")]
        string _link = "";

        [SerializeField, Range(0.001f, 1), Tooltip("Maximum distance of an object's origin from the gripping point in metres.")]
        float _reachMetres = 0.05f;

        RobotRig _source;
        MrilSession _session;
        SessionRobot _robot;
        CompensationSession _followed;
        ReachGrip _grip;
        [NonSerialized] string _name, _title, _problem;

        /// <summary>Name of the signal.</summary>
        public string Signal => _name ?? (string.IsNullOrEmpty(_signal) ? name : _signal);

        /// <summary>Frame name of the object that the gripper holds; null if it holds none.</summary>
        public string Held => _grip?.Held;

        /// <summary>
        /// Reason why <see cref="Held"/>, or the place of an object that was held, is unknown, in one line; null if it is known.
        /// </summary>
        public string Fault
        {
            get
            {
                if (!isActiveAndEnabled) return ObjectMessages.Disabled("grip by reach", name);
                if (_source == null) return StatusMessages.NoRig;
                if (_source.Session == null && _session != null) return PoseMessages.RigDisabled;
                if (_followed == null || _followed != _session.Session) return StatusMessages.NoSession;
                return _grip == null ? _problem ?? ObjectMessages.RobotUnknown : _grip.Fault;
            }
        }

        /// <summary>
        /// Sets the fields Rig and Signal, and follows the signal from now on. A script can call this method at any time, for example after it has
        /// created the object.
        /// </summary>
        /// <param name="rig">The rig whose robot carries the gripper; null to use the rig on a parent.</param>
        /// <param name="signal">Name of the signal; empty for the name of this object.</param>
        public void Follow(RobotRig rig, string signal = "")
        {
            var isFollowing = isActiveAndEnabled;
            if (isFollowing) OnDisable();
            _rig = rig;
            _signal = signal;
            if (isFollowing) OnEnable();
        }

        string IShownPart.Title => _title;

        bool IShownPart.IsFaultCommon => _grip != null && Fault == SignalMessages.ClockUnsynchronised;

        ControlTime? IShownPart.FaultSince => _grip?.FaultSince;

        void OnEnable()
        {
            _name = Signal;
            _title = "gripper " + name;
            _source = _rig != null ? _rig : GetComponentInParent<RobotRig>();
            if (_source == null) ConsoleLog.Warn(this, ComponentMessages.GripWithoutRig(name));
            Follow(SessionOfRig);
        }

        void OnDisable()
        {
            Follow(session: null);
            _name = null;
        }

        void OnTransformParentChanged()
        {
            if (!this.IsBelowAnotherRig(_rig, _source) && (_source != null || !this.IsBelowAnotherSession(null, _session))) return;
            OnDisable();
            OnEnable();
        }

        // Detects the session of a rig that is enabled after this component.
        void LateUpdate()
        {
            if (_source != null && SessionOfRig != _session) Follow(SessionOfRig);
        }

        // Without an enabled rig, the session that the rig would have lists this component, because what the gripper carries is unknown.
        MrilSession SessionOfRig => _source == null ? this.SessionOr(null)
            : _source.Session != null ? _source.Session : _source.SessionOr(_source.AssignedSession);

        void Follow(MrilSession session)
        {
            if (_session is object)
            {
                _session.Computed -= Show;
                _session.Parts.Remove(this);
                Drop();
            }
            _session = session;
            if (session == null) return;
            session.Computed += Show;
            session.Parts.Add(this);
        }

        void Show(DisplayFrame frame)
        {
            var robot = _source != null ? _source.Robot : null;
            if (_session.Session == _followed && robot == _robot) return;
            Drop();
            _followed = _session.Session;
            _robot = robot;
            if (_robot == null || _followed == null) return;
            var link = string.IsNullOrEmpty(_link) ? _robot.Robot.ToolLink.Name : _link;
            var index = _robot.Robot.IndexOfLink(link);
            if (index < 0)
            {
                _problem = ObjectMessages.NoLink(_robot.Robot.Name, link);
                ConsoleLog.Fail(this, ComponentMessages.Of("grip by reach", name, _problem));
                return;
            }
            _grip = new ReachGrip(_followed.Frames.Tree, _robot, index, _reachMetres, _session.Parts.Grippable);
            _followed.Grips.Add(_grip, Signal);
        }

        void Drop()
        {
            _problem = null;
            if (_grip != null) _followed.Grips.Remove(_grip);
            _grip = null;
            _followed = null;
            _robot = null;
        }
    }
}
