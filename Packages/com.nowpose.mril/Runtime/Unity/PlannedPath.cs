using System;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Robot;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Draws the path that the tool will take, if the control system publishes its set-points.</summary>
    /// <remarks>
    /// The line starts at the displayed tool. It ends where the plan ends, or at the time given in the Inspector. It is hidden while the pose is
    /// not current, while no plan is known, while the robot does not follow its plan, and while the robot stands on an object that can move, because
    /// set-points do not contain the motion of the object. If another robot carries the robot on a link, the line contains the planned motion of both.
    /// </remarks>
    [AddComponentMenu("Nowpose/Planned Path")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(LineRenderer))]
    public sealed class PlannedPath : MonoBehaviour
    {
        /// <summary>Time step between two points of the line, in s.</summary>
        const float Step = 1 / 30f;

        [SerializeField, Tooltip("The rig whose robot's path is drawn. Empty: the rig on a parent.")]
        RobotRig _rig = null;

        [SerializeField, Range(0.1f, 5), Tooltip("Maximum duration of the displayed path, in seconds from the displayed pose.")]
        float _aheadSeconds = 1;

        [SerializeField, Range(0.001f, 0.1f), Tooltip("Width of the line in metres.")]
        float _widthMetres = 0.004f;

        RobotRig _source;
        MrilSession _session;
        LineRenderer _line;
        readonly CarryingRigs _carriers = new CarryingRigs();
        Vector3[] _places = Array.Empty<Vector3>();
        int _count;
        bool _isCarrierUnplanned;
        [NonSerialized] string _fault = StatusMessages.NoSession;

        /// <summary>Time from the first to the last point of the line, in s; 0 while the line is hidden.</summary>
        public float DrawnSeconds { get; private set; }

        /// <summary>Reason why the line is hidden, in one line; null while it is drawn.</summary>
        public string Fault =>
            !isActiveAndEnabled ? ObjectMessages.Disabled("planned path", name) : _source == null ? StatusMessages.NoRig
                : !_source.isActiveAndEnabled ? PoseMessages.RigDisabled : _fault;

        void OnEnable()
        {
            _line = GetComponent<LineRenderer>();
            _line.useWorldSpace = true;
            _line.widthMultiplier = _widthMetres;
            if (_line.sharedMaterial == null)
                ConsoleLog.Warn(this, ComponentMessages.NoLineMaterial(name));
            Hide();
            _source = _rig != null ? _rig : GetComponentInParent<RobotRig>();
            if (_source == null) ConsoleLog.Warn(this, ComponentMessages.PathWithoutRig(name));
            else Follow(_source.Session);
        }

        void OnDisable()
        {
            Follow(null);
            _source = null;
        }

        void OnTransformParentChanged()
        {
            if (!this.IsBelowAnotherRig(_rig, _source)) return;
            OnDisable();
            OnEnable();
        }

        // Detects the session of a rig that is enabled after this component.
        void LateUpdate()
        {
            if (_source != null && _source.Session != _session) Follow(_source.Session);
        }

        void Follow(MrilSession session)
        {
            if (_session is object)
            {
                _session.Computed -= Show;
                _session.Hidden -= Hide;
            }
            Hide();
            _session = session;
            if (session == null) return;
            session.Computed += Show;
            session.Hidden += Hide;
        }

        void Show(DisplayFrame frame)
        {
            _fault = FaultIn(frame);
            if (_fault == null) Draw(_count);
            else Clear();
        }

        string FaultIn(DisplayFrame frame)
        {
            var robot = _source.Robot;
            if (robot == null) return StatusMessages.RobotNotAdded;
            if (!(frame.DisplayTime is ControlTime displayTime)) return StatusMessages.ReasonOf(PoseState.Unsynchronised);
            if (robot.Frame.SettledState != PoseState.Current)
                return StatusMessages.ReasonOf(robot.Frame.SettledState, robot.Frame.IsSettledLimitedByBase);
            if (_carriers.Find(_source) is string unknown) return unknown;
            _count = Plan(robot, displayTime);
            return _count >= 2 ? null : _isCarrierUnplanned ? PlannedPathMessages.CarrierWithoutPlan : PlannedPathMessages.NoPlan;
        }

        int Plan(SessionRobot robot, ControlTime displayTime)
        {
            var wanted = 1 + (int)Math.Round(_aheadSeconds / Step);
            if (_places.Length != wanted) _places = new Vector3[wanted];
            var link = robot.Robot.IndexOfLink(robot.Robot.ToolLink.Name);
            _isCarrierUnplanned = false;
            for (var count = 0; count < wanted; count++)
            {
                var at = displayTime + ClockTicks.Span(count * Step);
                if (!robot.TryPlan(link, at, out var tool)) return count;
                _places[count] = _source.transform.TransformPoint(UnityFrame.ToUnity(tool).Position());
                _isCarrierUnplanned = !_carriers.TryMove(at, ref _places[count]);
                if (_isCarrierUnplanned) return count;
            }
            return wanted;
        }

        void Draw(int count)
        {
            DrawnSeconds = (count - 1) * Step;
            _line.enabled = true;
            _line.positionCount = count;
            for (var i = 0; i < count; i++) _line.SetPosition(i, _places[i]);
        }

        void Hide()
        {
            _fault = StatusMessages.NoSession;
            Clear();
        }

        void Clear()
        {
            DrawnSeconds = 0;
            if (_line != null) _line.enabled = false;
        }
    }
}
