using System;
using System.Reflection;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Reads settings of Unity's OpenXR plug-in, com.unity.xr.openxr, if a project has it.</summary>
    /// <remarks>
    /// Uses reflection, because the setting exists from version 1.15 on and a project need not have the plug-in. Managed code stripping may
    /// remove the property, which no other code calls, but not the serialised field behind it.
    /// </remarks>
    static class OpenXrRenderSettings
    {
        const string TypeName = "UnityEngine.XR.OpenXR.OpenXRSettings, Unity.XR.OpenXR";

        /// <summary>Latency Optimization: PrioritizeRendering or PrioritizeInputPolling; null if the plug-in or the setting is missing.</summary>
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
                // A build may lack the plug-in's native library; the session must still work.
                return null;
            }
        }
    }
}
