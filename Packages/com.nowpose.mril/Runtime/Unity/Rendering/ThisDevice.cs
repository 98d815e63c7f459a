using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.XR;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Reads the conditions of this device, for which a calibration is valid. Allocates; do not call it in each frame.</summary>
    static class ThisDevice
    {
        const string BuiltInPipeline = "built-in";

        /// <summary>
        /// Conditions of device, display and player. The display may report its rate only some frames after the start of the scene.
        /// </summary>
        public static DisplayConditions Conditions => new DisplayConditions(
            OneLine(SystemInfo.deviceModel), DisplayHz(new List<XRDisplaySubsystem>()), SystemInfo.graphicsDeviceType.ToString(),
            SystemInfo.renderingThreadingMode.ToString(), RenderPipeline, latencyOptimization: OpenXrRenderSettings.LatencyOptimization);

        /// <summary>Returns the refresh rate in Hz; null if no display runs or the display does not report its rate.</summary>
        /// <param name="displays">Temporary list. This method overwrites it with the current displays.</param>
        public static double? DisplayHz(List<XRDisplaySubsystem> displays)
        {
            SubsystemManager.GetSubsystems(displays);
            return displays.Count > 0 && displays[0].TryGetDisplayRefreshRate(out var hertz)
                && hertz >= DisplayConditions.MinDisplayHz && hertz <= DisplayConditions.MaxDisplayHz
                ? hertz : (double?)null;
        }

        /// <summary>Replaces the characters of a device name that a profile does not accept, because they must not prevent a session.</summary>
        internal static string OneLine(string name) =>
            InputException.OneLine(name, DisplayConditions.MaxTextLength);

        static string RenderPipeline
        {
            get
            {
                var asset = GraphicsSettings.currentRenderPipeline;
                return asset == null ? BuiltInPipeline : asset.GetType().Name;
            }
        }
    }
}
