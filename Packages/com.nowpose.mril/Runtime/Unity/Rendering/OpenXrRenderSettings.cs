using System;
using System.Reflection;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Reads a setting of Unity's OpenXR plug-in (com.unity.xr.openxr), if the project has this plug-in.</summary>
    /// <remarks>
    /// Uses reflection, because the plug-in is optional and only version 1.15 and newer have the setting. If managed code stripping has removed
    /// the property, which no other code calls, the serialised field behind it is still present.
    /// </remarks>
    static class OpenXrRenderSettings
    {
        const string TypeName = "UnityEngine.XR.OpenXR.OpenXRSettings, Unity.XR.OpenXR";

        /// <summary>
        /// Value of Latency Optimization: PrioritizeRendering or PrioritizeInputPolling. Null if the plug-in or the setting is missing.
        /// </summary>
        public static string LatencyOptimization => LatencyOptimizationOf(Type.GetType(TypeName, throwOnError: false));

        /// <param name="settings">The plug-in's settings class; null if the plug-in is missing.</param>
        public static string LatencyOptimizationOf(Type settings)
        {
            try
            {
                var instance = settings?.GetProperty("Instance", BindingFlags.Public | BindingFlags.Static)?.GetValue(null);
                if (instance == null) return null;
                var value = settings.GetProperty("latencyOptimization")?.GetValue(instance)
                    ?? settings.GetField("m_latencyOptimization", BindingFlags.NonPublic | BindingFlags.Instance)?.GetValue(instance);
                return value?.ToString();
            }
            catch (TargetInvocationException)
            {
                // A build may lack the plug-in's native library. The session must work without it.
                return null;
            }
        }
    }
}
