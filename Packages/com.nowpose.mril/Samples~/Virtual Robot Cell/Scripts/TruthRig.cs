using System;
using Nowpose.Session;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Samples
{
    /// <summary>Makes the rig on this object represent the real robot: moves it to the true joint positions at the display time.</summary>
    [AddComponentMenu("Nowpose/Samples/Truth Rig")]
    [DefaultExecutionOrder(BeforeRigs)]
    [RequireComponent(typeof(RobotRig))]
    [DisallowMultipleComponent]
    public sealed class TruthRig : MonoBehaviour
    {
        // Runs before rigs, because a rig without a session logs a warning in Start unless it is already bound to a robot.
        const int BeforeRigs = -1;

        [SerializeField, Tooltip("The control system that moves the robot.")]
        SimulatedControlSystem _controlSystem = null;

        [SerializeField, Tooltip("This is the second robot, arm2. It needs Has Second Robot of the control system.")]
        bool _isSecondRobot = false;

        [SerializeField, Range(0, 200), Tooltip("True time from the start of a frame until its light appears, ms. It equals Visualisation Ms in "
            + "the session's settings if the display is calibrated. Set another value to see the effect of a calibration error.")]
        float _displayMs = 40;

        [SerializeField, Tooltip("Also show the tool. Off by default, because the tool of the real robot is virtual.")]
        bool _showsTool = false;

        RobotRig _rig;
        MrilSession _session;
        double[] _joints = Array.Empty<double>();

        void OnEnable()
        {
            _rig = GetComponent<RobotRig>();
            _session = _controlSystem != null ? _controlSystem.Session : null;
            if (_session != null) _session.Shown += Show;
            else Debug.LogError("[Nowpose] truth rig '" + name + "' has no control system with a session; assign one", this);
        }

        void OnDisable()
        {
            if (_session is null) return;
            _session.Shown -= Show;
            _session = null;
        }

        void Start()
        {
            if (_controlSystem != null) FollowRobot();
        }

        void Show(DisplayFrame frame)
        {
            FollowRobot();
            var displayTime = frame.Start + TimeSpan.FromTicks((long)(_displayMs * TimeSpan.TicksPerMillisecond));
            if (_controlSystem.TryGetTruth(displayTime, _joints, _isSecondRobot)) _rig.Apply(_joints);
        }

        void FollowRobot()
        {
            var robot = _controlSystem.Robot;
            if (robot == null || robot == _rig.Model) return;
            _rig.Bind(robot);
            _joints = new double[robot.MovingJoints.Count];
            foreach (Transform child in _rig.Flange)
                if (robot.IndexOfLink(child.name) >= 0) child.gameObject.SetActive(_showsTool);
        }
    }
}
