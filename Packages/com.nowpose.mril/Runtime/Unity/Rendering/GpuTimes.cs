using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.XR;

namespace Nowpose.Unity.Rendering
{
    /// <summary>How long the GPU worked on the newest frame, as its driver tells; where it does not, zero.</summary>
    sealed class GpuTimes
    {
        readonly List<XRDisplaySubsystem> _displays = new List<XRDisplaySubsystem>();
        readonly FrameTiming[] _timings = new FrameTiming[1];

        /// <summary>By the headset's runtime.</summary>
        public TimeSpan OfDisplay()
        {
            if (_displays.Count == 0 || !_displays[0].running) SubsystemManager.GetSubsystems(_displays);
            return _displays.Count > 0 && _displays[0].TryGetAppGPUTimeLastFrame(out var seconds)
                ? Length(seconds) : TimeSpan.Zero;
        }

        /// <summary>By Unity, where the player settings have Frame Timing Stats on; some frames late.</summary>
        public TimeSpan OfEngine()
        {
            FrameTimingManager.CaptureFrameTimings();
            return FrameTimingManager.GetLatestTimings(1, _timings) > 0 ? Length(_timings[0].gpuFrameTime / 1000) : TimeSpan.Zero;
        }

        // Drivers have been seen to report nonsense: what is no length of a frame is none.
        static TimeSpan Length(double seconds) =>
            seconds > 0 && seconds < 10 ? new TimeSpan((long)(seconds * TimeSpan.TicksPerSecond)) : TimeSpan.Zero;
    }
}
