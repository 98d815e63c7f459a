using System;
using System.Collections.Generic;
using Microsoft.MixedReality.OpenXR;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.XR;
using UnityEngine.XR.OpenXR;
using PluginMode = Microsoft.MixedReality.OpenXR.ReprojectionMode;
using ReprojectionMode = Nowpose.Latency.ReprojectionMode;

namespace Nowpose.OpenXR
{
    /// <summary>
    /// Reports how the display reprojects frames, and whether the application submits the depth buffer that depth reprojection needs. Needs
    /// Microsoft's Mixed Reality OpenXR plugin.
    /// </summary>
    /// <remarks>No runtime reports the mode that it uses. This component infers it from the requested mode; otherwise the mode is unknown.</remarks>
    [AddComponentMenu("Nowpose/Reprojection Check")]
    [DisallowMultipleComponent]
    public sealed class ReprojectionCheck : MonoBehaviour
    {
        const string DepthExtension = "XR_KHR_composition_layer_depth";

        /// <summary>Interval between checks. A check in each frame would allocate: the runtime's name is a new string at each call.</summary>
        static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(250);

        [SerializeField, Tooltip("The session that reports the result. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        readonly List<XRDisplaySubsystem> _displays = new List<XRDisplaySubsystem>();
        readonly DepthSubmissionWatch _watch = new DepthSubmissionWatch();
        MrilSession _target;
        ReprojectionMode? _imposed;
        HeadsetTime? _looked;
        bool _isRunning, _isMissing, _isLacking;

        /// <summary>Whether the application submits depth. A change is reported after it has lasted for one second.</summary>
        public DepthSubmission Depth => _watch.State;

        /// <summary>The reprojection mode of the display, inferred from the requested mode.</summary>
        public ReprojectionMode Mode { get; private set; }

        /// <summary>The mode that another component requests from the runtime in each frame; null if no component does.</summary>
        internal ReprojectionMode? Imposed
        {
            get => _imposed;
            set
            {
                if (_imposed == value) return;
                _imposed = value;
                Report();
            }
        }

        void OnEnable()
        {
            _isRunning = true;
            _target = this.RequiredSession(_session, "reprojection check");
        }

        void OnDisable()
        {
            _watch.Reset();
            (_isRunning, _looked, _isMissing, _isLacking) = (false, null, false, false);
            Report();
            _target = null;
        }

        void Update()
        {
            var now = _target.ClockOrDevices().Now;
            if (_isMissing || now - _looked < Interval) return;
            _looked = now;
            try
            {
                if (_watch.Follow(now, Observe().Judge())) LogState();
                Report();
            }
            catch (TypeLoadException fault)
            {
                // The build may lack a plugin's native library. Handles the exception, so that the rest of the frame is still computed.
                _isMissing = true;
                _watch.Reset();
                Report();
                ConsoleLog.Warn(this, DeviceMessages.DepthUnknown(name, fault.Message));
            }
        }

        DepthObservation Observe()
        {
            var display = RunningDisplay();
            if (display == null || OpenXRRuntime.name.Length == 0) return default;
            var settings = OpenXRSettings.Instance;
            return new DepthObservation(
                isRunning: true,
                isTurnedOn: settings != null && settings.depthSubmissionMode != OpenXRSettings.DepthSubmissionMode.None,
                isSupported: OpenXRRuntime.IsExtensionEnabled(DepthExtension),
                hasMainCamera: Camera.main != null,
                isRequested: AsksForDepth(display));
        }

        XRDisplaySubsystem RunningDisplay()
        {
            if (_displays.Count == 0 || !_displays[0].running) SubsystemManager.GetSubsystems(_displays);
            return _displays.Count > 0 && _displays[0].running ? _displays[0] : null;
        }

        static bool? AsksForDepth(XRDisplaySubsystem display)
        {
            var count = display.GetRenderPassCount();
            if (count == 0) return null;
            for (var i = 0; i < count; i++)
            {
                display.GetRenderPass(i, out var pass);
                if (pass.shouldFillOutDepth) return true;
            }
            return false;
        }

        void Report()
        {
            Mode = _isRunning ? _imposed ?? ModeByDefault() : ReprojectionMode.Unknown;
            if (_target == null) return;
            _target.Reprojection = Mode;
            _target.DepthSubmission = Depth;
        }

        ReprojectionMode ModeByDefault()
        {
            var display = _isMissing ? null : RunningDisplay();
            if (display == null) return ReprojectionMode.Unknown;
            switch (display.reprojectionMode)
            {
                case XRDisplaySubsystem.ReprojectionMode.None: return ReprojectionMode.None;
                case XRDisplaySubsystem.ReprojectionMode.OrientationOnly: return ReprojectionMode.OrientationOnly;
            }
            return Depth == DepthSubmission.Active && Supports(PluginMode.Depth) ? ReprojectionMode.Depth : ReprojectionMode.Unknown;
        }

        /// <summary>Returns whether the runtime supports a mode; false before the runtime's session has started. Does not allocate.</summary>
        internal static bool Supports(PluginMode mode)
        {
            var modes = ViewConfiguration.Primary?.SupportedReprojectionModes;
            for (var i = 0; i < (modes?.Count ?? 0); i++)
                if (modes[i] == mode) return true;
            return false;
        }

        void LogState()
        {
            var problem = DepthSubmissionMessages.ProblemOf(Depth);
            if (problem != null) ConsoleLog.Warn(this, problem);
            else if (Depth == DepthSubmission.Active) ConsoleLog.Info(this, _isLacking ? DeviceMessages.DepthAgain : DeviceMessages.DepthSubmitted);
            _isLacking = problem != null;
        }
    }
}
