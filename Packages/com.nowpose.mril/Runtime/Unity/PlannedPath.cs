using System;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Draws the path that the tool will take, if the control system publishes its set-points.</summary>
    /// <remarks>
    /// The line starts at the displayed tool. It ends where the plan ends, or at the time given in the Inspector. It is hidden while the pose is
    /// not current, while no plan is known, while the robot does not follow its plan, and while the robot stands on something that moves, because the
    /// plan does not contain the motion of the base.
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
        Vector3[] _places = Array.Empty<Vector3>();

        /// <summary>Time from the first to the last point of the line, in s; 0 while the line is hidden.</summary>
        public float DrawnSeconds { get; private set; }

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
            var robot = _source.Robot;
            var count = robot != null && frame.DisplayTime is ControlTime displayTime && robot.Frame.State == PoseState.Current && IsBaseFixed(robot)
                ? Plan(robot, displayTime)
                : 0;
            if (count < 2) Hide();
            else Draw(count);
        }

        // Without a frame of its own, the robot stands on the object or robot above the rig.
        bool IsBaseFixed(SessionRobot robot)
        {
            if (robot.HasRootFrame) return robot.HasFixedRootFrame;
            for (var at = _source.transform; at != null; at = at.parent)
            {
                if (at.TryGetComponent<ICellObject>(out var shown)) return shown.IsFixed;
                if (at.TryGetComponent<RobotRig>(out var other) && other != _source) return false;
            }
            return true;
        }

        int Plan(SessionRobot robot, ControlTime displayTime)
        {
            var wanted = 1 + (int)Math.Round(_aheadSeconds / Step);
            if (_places.Length != wanted) _places = new Vector3[wanted];
            var count = 0;
            for (; count < wanted; count++)
            {
                var at = displayTime + ClockTicks.Span(count * Step);
                if (!robot.TryPlanTool(at, out var tool)) break;
                _places[count] = _source.transform.TransformPoint(UnityFrame.ToUnity(tool).Position());
            }
            return count;
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
            DrawnSeconds = 0;
            if (_line != null) _line.enabled = false;
        }
    }
}
