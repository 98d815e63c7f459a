using System;
using Microsoft.MixedReality.OpenXR;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;
using PluginMode = Microsoft.MixedReality.OpenXR.ReprojectionMode;
using ReprojectionMode = Nowpose.Latency.ReprojectionMode;

namespace Nowpose.OpenXR
{
    /// <summary>
    /// Experimental: requests planar reprojection from the display. The plane goes through the tool of a rig, faces the viewer, and moves with the
    /// predicted velocity of the tool.
    /// </summary>
    /// <remarks>
    /// A request is valid for one frame, so this component repeats it in each frame. When the component is disabled, the runtime returns to
    /// its previous mode. The pose of the tool is already predicted to the display time, so a velocity may make the runtime compensate the
    /// motion a second time.
    /// </remarks>
    [AddComponentMenu("Nowpose/Experimental Planar Reprojection")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(ReprojectionCheck))]
    public sealed class ExperimentalPlanarReprojection : MonoBehaviour
    {
        [SerializeField, Tooltip("Experiment. The rig whose tool lies in the plane. Empty: the rig on this object or a child.")]
        RobotRig _rig = null;

        [SerializeField, Tooltip("Experiment. Also sends the velocity of the predicted tool. Off: the plane does not move while the frame is "
            + "shown. On: the motion may be counted twice, because the pose is already predicted to the display time.")]
        bool _sendVelocity = true;

        readonly ToolVelocity _velocity = new ToolVelocity();
        ReprojectionCheck _check;
        RobotRig _source;
        SessionRobot _robot;
        bool _isMissing;
        int _requestFrame;

        /// <summary>Reason why the plane is not in use, in one line; null if the plane is in use or the runtime's session has not started.</summary>
        [field: NonSerialized] public string Problem { get; private set; }

        /// <summary>Whether the request contains the velocity of the predicted tool.</summary>
        public bool SendVelocity
        {
            get => _sendVelocity;
            set => _sendVelocity = value;
        }

        void OnEnable()
        {
            _check = GetComponent<ReprojectionCheck>();
            _source = _rig != null ? _rig : GetComponentInChildren<RobotRig>();
            if (_source == null)
            {
                Refuse(DeviceMessages.PlanarWithoutRig);
                return;
            }
            _source.Posed += Ask;
        }

        void OnDisable()
        {
            if (_source is object) _source.Posed -= Ask;
            _velocity.Reset();
            _check.Imposed = null;
            _source = null;
            _isMissing = false;
            Problem = null;
        }

        // The rig may compute its pose, and so repeat the request, after this Update. A request from the previous frame is therefore still current.
        void Update()
        {
            if (_check.Imposed == null || Time.frameCount - _requestFrame <= 1) return;
            _check.Imposed = null;
            Problem = DeviceMessages.PlanarPaused;
        }

        // The rig calls this method after each computed pose: once per frame or, if the session computes the pose again right before rendering,
        // twice.
        void Ask()
        {
            if (_isMissing) return;
            if (Problem == DeviceMessages.PlanarPaused) Problem = null;
            FollowVelocity();
            try
            {
                var view = ViewConfiguration.Primary;
                if (view == null || !view.IsActive || _source.Tool == null) _check.Imposed = null;
                else if (!ReprojectionCheck.Supports(PluginMode.PlanarManual))
                    Refuse(DeviceMessages.PlanarNotSupported);
                else Impose(view);
            }
            catch (TypeLoadException fault)
            {
                // The build may lack the plugin's native library. Handles the exception, so that the rest of the frame is still computed.
                _isMissing = true;
                Refuse(DeviceMessages.PlanarRefused(fault.Message));
            }
        }

        void Impose(ViewConfiguration view)
        {
            var camera = Camera.main;
            var tool = _source.Tool.position;
            var settings = new ReprojectionSettings
            {
                ReprojectionMode = PluginMode.PlanarManual,
                ReprojectionPlaneOverridePosition = tool,
            };
            if (camera != null) settings.ReprojectionPlaneOverrideNormal = -camera.transform.forward;
            if (_sendVelocity && _velocity.Value is { } velocity)
                settings.ReprojectionPlaneOverrideVelocity = _source.transform.TransformDirection(UnityFrame.DirectionToUnity(velocity).Vector());
            view.SetReprojectionSettings(settings);
            Problem = null;
            _requestFrame = Time.frameCount;
            _check.Imposed = ReprojectionMode.PlanarManual;
        }

        // The velocity is known only if the rig follows a robot of a session and shows its pose at the display time.
        void FollowVelocity()
        {
            var robot = _source.IsFollowing && _source.Shows == RigPose.Displayed ? _source.Robot : null;
            if (robot != _robot) _velocity.Reset();
            _robot = robot;
            if (robot != null) _velocity.Follow(robot.Frame);
        }

        void Refuse(string why)
        {
            if (_check != null) _check.Imposed = null;
            if (Problem == null) ConsoleLog.Warn(this, DeviceMessages.PlanarLog(name, why));
            Problem = DeviceMessages.PlanarProblem(why);
        }
    }
}
