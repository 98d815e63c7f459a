using System;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Robot;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Shows a robot by means of transforms that are named and nested in the same way as its links. A session or a script moves them.
    /// </summary>
    /// <remarks>
    /// The rig's own transform is the robot's base frame. If no transform below the rig has the name of the root link and nothing is drawn there,
    /// the rig builds the robot from primitives.
    /// </remarks>
    [AddComponentMenu("Nowpose/Robot Rig")]
    [DisallowMultipleComponent]
    public sealed class RobotRig : MonoBehaviour
    {
        [SerializeField, Tooltip("The session that moves this robot. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Namespace of the robot in the cell, such as arm2 for /arm2/joint_states. Empty: the session's own robot.")]
        string _robotNamespace = "";

        [SerializeField, Tooltip("Description of a robot in a namespace. Not used for the session's own robot.")]
        RobotDescriptionAsset _description = null;

        [SerializeField, Tooltip("Displayed: the robot's pose at the time when the light reaches the eye. Held: the newest sample, for "
            + "comparison.")]
        RigPose _shows = RigPose.Displayed;

        [SerializeField, Tooltip("Material of the links up to the flange, for a robot built from primitives. Choose an occluder if the real arm "
            + "should hide the objects behind it.")]
        Material _armMaterial = null;

        [SerializeField, Tooltip("Material of the links that the flange carries, for a robot built from primitives.")]
        Material _toolMaterial = null;

        readonly Listeners<Action> _bound = new Listeners<Action>(), _posed = new Listeners<Action>();
        MrilSession _source;
        RigRobot _robot;
        RobotModel _refused;
        RigHierarchy _hierarchy;
        GameObject _built;
        Material _plain;
        bool _isMaterialReported;
        Vector3 _shift, _unshifted;
        double[] _joints = Array.Empty<double>();

        /// <summary>Raised after the transforms were bound to a robot.</summary>
        public event Action Bound { add => _bound.Add(value); remove => _bound.Remove(value); }

        /// <summary>Raised after the transforms were moved. This may happen twice per frame.</summary>
        public event Action Posed { add => _posed.Add(value); remove => _posed.Remove(value); }

        /// <summary>The displayed robot; null before <see cref="Bind"/>.</summary>
        public RobotModel Model { get; private set; }

        /// <summary>The session that moves this rig; null while the rig is disabled, and if a script moves the rig.</summary>
        public MrilSession Session => _source;

        /// <summary>The session that is assigned in the Inspector or by a script; null to use the session on this object or a parent.</summary>
        internal MrilSession AssignedSession => _session;

        /// <summary>Raised when the rig may have got another session.</summary>
        internal event Action Followed;

        internal bool IsOf(MrilSession session) => this.IsOf(_session, session);

        /// <summary>The transform that is the frame <c>world</c>; null while the rig is disabled, equal to null if it was destroyed.</summary>
        internal Transform World => _source != null ? _robot.World : null;

        /// <summary>Namespace of the robot in the cell; empty for the session's own robot.</summary>
        public string RobotNamespace => _robotNamespace ?? "";

        /// <summary>The robot in the session of the last frame; null while it is unknown or the rig is disabled.</summary>
        internal SessionRobot Robot => _source != null && !IsRobotUnknown ? _robot.Robot : null;

        // The session's own robot may be unknown while objects and other robots are shown.
        bool IsRobotUnknown => RobotNamespace.Length == 0 && _source.Robot == null;

        /// <summary>Displacement of the rig from the robot's base in the axes of the base, in metres. Frames that place the base keep it.</summary>
        internal Vector3 Shift
        {
            get => _shift;
            set
            {
                if (_shift.sqrMagnitude == 0) _unshifted = transform.localPosition;
                _shift = value;
                Displace();
            }
        }

        /// <summary>Reason why the robot's pose is not current, in one line; null if it is current.</summary>
        internal string Fault =>
            _source != null ? _robot.Fault : isActiveAndEnabled ? StatusMessages.NoSession : ObjectMessages.Disabled("rig", name);

        /// <summary>Returns the state that the robot's look shows in a frame of the session.</summary>
        internal PoseState StateIn(DisplayFrame frame) => _robot == null ? frame.SettledState : _robot.StateIn(frame);

        /// <summary>Whether this rig is enabled and bound to the robot that its session moves.</summary>
        public bool IsFollowing => _source != null && Model != null && Model == _robot.Model;

        public RigPose Shows => _shows;

        /// <summary>Material of the links up to the flange, for a robot that the rig builds; null if none is assigned.</summary>
        internal Material ArmMaterial => _armMaterial;

        /// <summary>The joint positions of the last <see cref="Apply"/>, one per moving joint of the model, in rad or m; zeros before it.</summary>
        public ReadOnlySpan<double> Joints => _joints;

        /// <summary>The tool centre point, or the flange if the robot has no tool; null before <see cref="Bind"/>.</summary>
        public Transform Tool => _hierarchy?.Tool;

        /// <summary>The link that a tool is mounted on; null before <see cref="Bind"/>.</summary>
        public Transform Flange => _hierarchy?.Flange;

        /// <summary>Returns the transform of a link; null if the robot has no such link, and before <see cref="Bind"/>.</summary>
        public Transform Link(string name) => _hierarchy?.Link(name);

        /// <inheritdoc cref="RigHierarchy.LinkAbove"/>
        internal int LinkAbove(Transform below, out Transform place)
        {
            place = null;
            return _hierarchy?.LinkAbove(below, out place) ?? -1;
        }

        /// <summary>
        /// Sets the fields of the Inspector that select the shown robot, and follows it from now on. A script can call this method at any time,
        /// for example after it has added the component.
        /// </summary>
        /// <param name="session">The session that moves this robot; null to use the session on this object or a parent.</param>
        /// <param name="robotNamespace">Namespace of the robot in the cell; empty for the session's own robot.</param>
        /// <param name="description">Description of a robot in a namespace. Not used for the session's own robot.</param>
        /// <param name="shows">Selects the pose at the display time or that of the newest sample.</param>
        public void Follow(
            MrilSession session, string robotNamespace = "", RobotDescriptionAsset description = null, RigPose shows = RigPose.Displayed)
        {
            var isFollowing = isActiveAndEnabled;
            if (isFollowing) OnDisable();
            _session = session;
            _robotNamespace = robotNamespace;
            _description = description;
            _shows = shows;
            if (isFollowing) OnEnable();
            Followed?.Invoke();
        }

        /// <summary>Binds the transforms below the rig to the links of a robot, or builds them. Sets all joint positions to 0.</summary>
        /// <exception cref="InputException">
        /// A link is missing, misplaced or scaled, or the objects below the rig show another robot. The rig is then not bound to any robot.
        /// </exception>
        public void Bind(RobotModel model)
        {
            if (model == null) throw new ArgumentNullException(nameof(model));
            if (model != Model) Unbuild();
            (Model, _hierarchy) = (null, null);
            _hierarchy = RigHierarchy.Find(model, transform) ?? Built(model);
            _joints = new double[model.MovingJoints.Count];
            Model = model;
            _bound.Raise(this);
        }

        /// <summary>Moves the links to joint positions.</summary>
        /// <param name="joints">One position per moving joint of the model, including mimic joints, in rad or m.</param>
        public void Apply(ReadOnlySpan<double> joints)
        {
            if (Model == null) throw new InvalidOperationException(RigMessages.NotBound(name));
            if (joints.Length != _joints.Length)
                throw new ArgumentException(RigMessages.ValueCount(name, joints.Length, _joints.Length), nameof(joints));
            joints.CopyTo(_joints);
            _hierarchy.Apply(joints);
            _posed.Raise(this);
        }

        /// <summary>Whether the objects below the rig have the root link of a robot. Other links may be missing. Changes nothing.</summary>
        internal bool HasLinksOf(RobotModel model) => RigHierarchy.RootLink(model, transform) != null;

        /// <summary>
        /// Builds the robot as a permanent part of a scene or prefab. At run time, the rig finds these links and never removes them.
        /// </summary>
        /// <param name="plain">
        /// Material that replaces missing materials. It must be an asset, because a prefab does not save a material that exists only in memory.
        /// </param>
        /// <returns>The object of the root link.</returns>
        /// <exception cref="InputException">The objects below the rig show another robot.</exception>
        internal GameObject BuildToStay(RobotModel model, Material plain)
        {
            RigHierarchy.RequireEmpty(model, transform);
            return NewLinks(model, plain, out _);
        }

        void OnEnable()
        {
            _source = this.SessionOr(_session);
            if (_source == null) return;
            _robot = new RigRobot(this, RobotNamespace, _description, _source);
            _source.Movers.Add(this, Show);
        }

        void OnDisable()
        {
            if (_source is null) return;
            _source.Movers.Remove(this);
            _robot.Leave();
            (_source, _refused) = (null, null);
        }

        void OnTransformParentChanged()
        {
            if (_source != null) _robot.FindWorld();
            if (!this.IsBelowAnotherSession(_session, _source)) return;
            OnDisable();
            OnEnable();
            Followed?.Invoke();
        }

        void Start()
        {
            if (_source != null) FollowRobot();
            else if (Model == null) ConsoleLog.Warn(this, ComponentMessages.RigWithoutSession(name));
        }

        void OnDestroy()
        {
            if (_built != null) Destroy(_built);
            if (_plain != null) Destroy(_plain);
        }

        void Show(DisplayFrame frame)
        {
            if (IsRobotUnknown) return;
            var shown = _robot.FrameIn(_source.Session, frame);
            FollowRobot();
            if (shown == null || !IsFollowing) return;
            // The base moves first, because listeners of Posed read the links' poses in the world.
            if (_robot.PlaceBase() && _shift.sqrMagnitude > 0)
            {
                _unshifted = transform.localPosition;
                Displace();
            }
            Apply(_shows == RigPose.Held ? shown.HeldJoints : shown.Joints);
        }

        void Displace() => transform.localPosition = _unshifted + transform.localRotation * _shift;

        // Must not be called in OnEnable, because Unity does not allow the removal of children while it enables objects.
        void FollowRobot()
        {
            var robot = _robot.Model;
            if (robot == null || robot == _refused || (robot == Model && _hierarchy.IsWhole)) return;
            _refused = null;
            try
            {
                Bind(robot);
            }
            catch (InputException fault)
            {
                _refused = robot;
                ConsoleLog.Fail(this, fault.Message);
            }
        }

        RigHierarchy Built(RobotModel model)
        {
            _built = NewLinks(model, null, out _plain);
            return RigHierarchy.Find(model, transform);
        }

        GameObject NewLinks(RobotModel model, Material plain, out Material made)
        {
            var look = new PlainLook(_armMaterial != null ? _armMaterial : plain, _toolMaterial != null ? _toolMaterial : plain);
            var links = RigBuilder.Build(model, transform, look);
            made = look.Made;
            if (look.LacksMaterial && !_isMaterialReported) ConsoleLog.Warn(this, RigMessages.NoMaterial(name, made != null));
            _isMaterialReported |= look.LacksMaterial;
            return links;
        }

        // Destroy takes effect at the end of the frame. Detaches the links first, so that a search below the rig no longer finds them.
        void Unbuild()
        {
            if (_built == null) return;
            _built.transform.SetParent(null, worldPositionStays: false);
            Discard(_built);
            if (_plain != null) Discard(_plain);
            (_built, _plain) = (null, null);
        }

        static void Discard(UnityEngine.Object made)
        {
            if (Application.isPlaying) Destroy(made);
            else DestroyImmediate(made);
        }
    }
}
