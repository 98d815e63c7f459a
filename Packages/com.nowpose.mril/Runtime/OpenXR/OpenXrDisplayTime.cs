using System;
using Microsoft.MixedReality.OpenXR;
using Nowpose.Counter;
using Nowpose.Latency;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.OpenXR
{
    /// <summary>
    /// Supplies the session with the display time of each frame, as predicted by the OpenXR runtime. Needs Microsoft's Mixed Reality OpenXR
    /// plugin.
    /// </summary>
    /// <remarks>
    /// The runtime's times are counts of Windows' performance counter, at the frequency of that counter. This component converts them to
    /// counts of <see cref="System.Diagnostics.Stopwatch"/>, which Unity scales to 10 MHz, and then to the session's clock. The session uses
    /// the calibrated L_visu in these cases: the runtime returns no time (in the Editor, or before the runtime's session runs), the platform
    /// has no performance counter, or the session's clock is not based on the stopwatch.
    /// </remarks>
    [AddComponentMenu("Nowpose/Display Time")]
    [DisallowMultipleComponent]
    public sealed class OpenXrDisplayTime : MonoBehaviour, IDisplayTimeSource
    {
        [SerializeField, Tooltip("The session that receives the display times. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        MrilSession _target;
        CounterPairing _pairing;
        bool _isUnusable, _isMissing, _isNotRewritten;

        /// <summary>Opens the counter whose counts are the runtime's times. Tests replace it.</summary>
        internal Func<ICounter> OpenCounter { get; set; } = () => new WindowsPerformanceCounter();

        /// <summary>The counter on which the session's clock is based. Tests replace it.</summary>
        internal ICounter Stopwatch { get; set; } = new StopwatchCounter();

        /// <summary>
        /// Returns the predicted display time of this frame. In Update the runtime predicts it from the previous frame; right before rendering,
        /// from this frame.
        /// </summary>
        public HeadsetTime? LightOf(HeadsetTime frameStart)
        {
            var clock = _target != null ? _target.HeadsetClock as IPerformanceCounterClock : null;
            if (clock == null || _isMissing) return null;
            try
            {
                var count = PredictedCount(_target.IsBeforeRender ? FrameTime.OnBeforeRender : FrameTime.OnUpdate);
                return count > 0 && IsPaired() ? clock.At(_pairing.ToTarget(count)) : (HeadsetTime?)null;
            }
            catch (TypeLoadException fault)
            {
                // The build may lack the plugin's native library. Handles the exception, so that the rest of the frame is still computed.
                GiveUp(fault.Message);
                return null;
            }
        }

        /// <returns>Count of the performance counter; 0 if the runtime returns no time.</returns>
        static long PredictedCount(FrameTime tick)
        {
            var predicted = OpenXRTime.Current.GetPredictedDisplayTimeInXrTime(tick);
            return predicted > 0 ? OpenXRTime.Current.ConvertXrTimeToQpcTime(predicted) : 0;
        }

        // One measurement is sufficient, because both counters use the same oscillator.
        bool IsPaired()
        {
            if (_pairing != null) return true;
            if (CounterPairing.TryMeasure(OpenCounter, Stopwatch, out _pairing, out var fault))
                ConsoleLog.Info(this, DeviceMessages.CountersPaired(
                    name, _pairing.Frequency, Stopwatch.Frequency, _pairing.Uncertainty.TotalMilliseconds * 1000));
            else GiveUp(fault);
            return _pairing != null;
        }

        void GiveUp(string fault)
        {
            _isMissing = true;
            ConsoleLog.Warn(this, DeviceMessages.NoDisplayTime(name, fault));
        }

        void OnEnable()
        {
            _target = this.RequiredSession(_session, "display time");
            if (_target != null) _target.DisplayTimeSource = this;
        }

        void OnDisable()
        {
            if (_target != null && ReferenceEquals(_target.DisplayTimeSource, this)) _target.DisplayTimeSource = null;
            _target = null;
            _isUnusable = false;
            _isMissing = false;
            _isNotRewritten = false;
        }

        void Update()
        {
            if (_target == null) return;
            var isUnusable = !(_target.HeadsetClock is IPerformanceCounterClock);
            if (isUnusable && !_isUnusable)
                ConsoleLog.Warn(this, DeviceMessages.NoDisplayTime(name, DeviceMessages.OtherClock));
            _isUnusable = isUnusable;
            var isNotRewritten = _target.Session != null && !_target.Session.Settings.RewriteBeforeRender;
            if (isNotRewritten && !_isNotRewritten) ConsoleLog.Warn(this, DeviceMessages.NotRewritten(name));
            _isNotRewritten = isNotRewritten;
        }
    }
}
