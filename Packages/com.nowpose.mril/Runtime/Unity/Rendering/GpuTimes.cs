using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.XR;

namespace Nowpose.Unity.Rendering
{
    /// <summary>GPU time of the newest frame as reported by the driver; zero if it is not reported.</summary>
    sealed class GpuTimes
    {
        readonly List<XRDisplaySubsystem> _displays = new List<XRDisplaySubsystem>();
        readonly FrameTiming[] _timings = new FrameTiming[1];

        /// <summary>Returns the time reported by the headset's runtime.</summary>
        public TimeSpan OfDisplay()
        {
            if (_displays.Count == 0 || !_displays[0].running) SubsystemManager.GetSubsystems(_displays);
            return _displays.Count > 0 && _displays[0].TryGetAppGPUTimeLastFrame(out var seconds)
                ? Length(seconds) : TimeSpan.Zero;
        }

        /// <summary>Returns the time reported by Unity if Frame Timing Stats are on in the player settings; some frames late.</summary>
        public TimeSpan OfEngine()
        {
            FrameTimingManager.CaptureFrameTimings();
            return FrameTimingManager.GetLatestTimings(1, _timings) > 0 ? Length(_timings[0].gpuFrameTime / 1000) : TimeSpan.Zero;
        }

        // Some drivers report invalid values; values that cannot be a frame's duration count as unknown.
        static TimeSpan Length(double seconds) =>
            seconds > 0 && seconds < 10 ? new TimeSpan((long)(seconds * TimeSpan.TicksPerSecond)) : TimeSpan.Zero;
    }
}
