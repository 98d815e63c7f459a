using System;
using Microsoft.MixedReality.OpenXR;
using Nowpose.Latency;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.OpenXR
{
    /// <summary>
    /// Tells the session when each frame's light appears, as OpenXR's runtime predicts it; needs Microsoft's Mixed Reality
    /// OpenXR plugin.
    /// </summary>
    /// <remarks>
    /// The calibrated L_visu counts wherever the runtime tells nothing: in the Editor, before its session runs, and when the session's
    /// clock is not the device's performance counter, on which alone the runtime's times mean anything.
    /// </remarks>
    [AddComponentMenu("Nowpose/Display Time")]
    [DisallowMultipleComponent]
    public sealed class OpenXrDisplayTime : MonoBehaviour, IDisplayTimeSource
    {
        [SerializeField, Tooltip("The session that is told. Empty: the one on this object or above.")]
        MrilSession _session = null;

        MrilSession _target;
        bool _isUnusable, _isMissing;

        /// <summary>
        /// As the runtime predicts it: for the first computation of a frame from the frame before, right before rendering for
        /// this one.
        /// </summary>
        public HeadsetTime? LightOf(HeadsetTime frameStart)
        {
            var clock = _target != null ? _target.HeadsetClock as IPerformanceCounterClock : null;
            if (clock == null || _isMissing) return null;
            try
            {
                var count = PredictedCount(_target.IsBeforeRender ? FrameTime.OnBeforeRender : FrameTime.OnUpdate);
                return count > 0 ? clock.At(count) : (HeadsetTime?)null;
            }
            catch (TypeLoadException fault)
            {
                // A build may lack the plugin's native library; the frame must not.
                _isMissing = true;
                ConsoleLog.Warn(this, "display time '" + name + "': " + fault.Message + "; light appears as calibrated");
                return null;
            }
        }

        /// <returns>0 where the runtime tells none.</returns>
        static long PredictedCount(FrameTime tick)
        {
            var predicted = OpenXRTime.Current.GetPredictedDisplayTimeInXrTime(tick);
            return predicted > 0 ? OpenXRTime.Current.ConvertXrTimeToQpcTime(predicted) : 0;
        }

        void OnEnable()
        {
            _target = this.SessionOr(_session);
            if (_target == null) ConsoleLog.Warn(this, "display time '" + name + "' has no session above it to tell; assign one");
            else _target.DisplayTimeSource = this;
        }

        void OnDisable()
        {
            if (_target != null && ReferenceEquals(_target.DisplayTimeSource, this)) _target.DisplayTimeSource = null;
            _target = null;
            _isUnusable = false;
            _isMissing = false;
        }

        void Update()
        {
            if (_target == null) return;
            var isUnusable = !(_target.HeadsetClock is IPerformanceCounterClock);
            if (isUnusable && !_isUnusable)
                ConsoleLog.Warn(this, "display time '" + name + "': the session's clock is not the performance counter; light appears as calibrated");
            _isUnusable = isUnusable;
        }
    }
}
