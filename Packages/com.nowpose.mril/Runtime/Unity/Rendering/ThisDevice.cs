using System.Collections.Generic;
using Nowpose.Latency;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.XR;

namespace Nowpose.Unity
{
    /// <summary>The conditions of this device that a calibration holds for. Allocates: not for each frame.</summary>
    static class ThisDevice
    {
        const string BuiltInPipeline = "built-in";

        /// <summary>Conditions of device, display and player. The display may report its rate some frames after the scene begins.</summary>
        public static DisplayConditions Conditions => new DisplayConditions(
            SystemInfo.deviceModel, DisplayHz, SystemInfo.graphicsDeviceType.ToString(), SystemInfo.renderingThreadingMode.ToString(),
            RenderPipeline, latencyOptimization: OpenXrRenderSettings.LatencyOptimization);

        /// <summary>Null where no display runs or where it does not report its rate.</summary>
        static double? DisplayHz
        {
            get
            {
                var displays = new List<XRDisplaySubsystem>();
                SubsystemManager.GetSubsystems(displays);
                return displays.Count > 0 && displays[0].TryGetDisplayRefreshRate(out var hertz) && hertz >= 1 && hertz <= 1000
                    ? hertz : (double?)null;
            }
        }

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
