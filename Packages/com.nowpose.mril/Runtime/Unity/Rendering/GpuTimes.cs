using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.XR;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Reads the GPU time of the newest frame. Its methods return zero if the driver does not report this time.</summary>
    sealed class GpuTimes
    {
        /// <summary>
        /// Value from which a display reports milliseconds, as com.unity.xr.openxr did before version 1.18; since then, it reports seconds.
        /// </summary>
        const double MinMilliseconds = 0.25;

        readonly List<XRDisplaySubsystem> _displays = new List<XRDisplaySubsystem>();
        readonly FrameTiming[] _timings = new FrameTiming[1];

        /// <summary>Returns the time reported by the headset's runtime.</summary>
        public TimeSpan OfDisplay()
        {
            if (_displays.Count == 0 || !_displays[0].running) SubsystemManager.GetSubsystems(_displays);
            return _displays.Count > 0 && _displays[0].TryGetAppGPUTimeLastFrame(out var time)
                ? Length(time < MinMilliseconds ? time : time / 1000) : TimeSpan.Zero;
        }

        /// <summary>
        /// Returns the time reported by Unity, which is some frames old. Needs Frame Timing Stats enabled in the player settings.
        /// </summary>
        public TimeSpan OfEngine()
        {
            FrameTimingManager.CaptureFrameTimings();
            return FrameTimingManager.GetLatestTimings(1, _timings) > 0 ? Length(_timings[0].gpuFrameTime / 1000) : TimeSpan.Zero;
        }

        // Some drivers report invalid values. A value that cannot be the duration of a frame is treated as not reported.
        static TimeSpan Length(double seconds) =>
            seconds > 0 && seconds < 10 ? new TimeSpan((long)(seconds * TimeSpan.TicksPerSecond)) : TimeSpan.Zero;
    }
}
