using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>
/// Creates OpenXR settings with the serialised fields of com.unity.xr.openxr 1.15. As in a new project, no feature is enabled.
/// </summary>
static class OpenXrAssets
{
    public const string HoloLens = "com.microsoft.openxr.feature.hololens";

    static readonly string[] Features =
    {
        "com.microsoft.openxr.feature.appremoting", HoloLens, "com.microsoft.openxr.feature.handtracking",
        "com.unity.openxr.feature.input.handtracking", "com.unity.openxr.feature.input.eyetracking",
    };

    /// <summary>Adds the settings to the open project.</summary>
    public static void Put(Func<ScriptableObject, ScriptableObject> keep, params BuildTargetGroup[] players) => Put<NewOpenXRSettings>(keep, players);

    /// <summary>Adds the settings of a plug-in older than version 1.15 to the open project.</summary>
    public static void PutOld(Func<ScriptableObject, ScriptableObject> keep, params BuildTargetGroup[] players) => Put<OpenXRSettings>(keep, players);

    static void Put<T>(Func<ScriptableObject, ScriptableObject> keep, BuildTargetGroup[] players) where T : OpenXRSettings
    {
        var all = New<OpenXRPackageSettings>(keep);
        all.Keys = [.. players];
        all.Values = [.. players.Select(_ => Settings<T>(keep))];
        Project.Put("Assets/XR/Settings/OpenXR Package Settings.asset", all);
    }

    static T Settings<T>(Func<ScriptableObject, ScriptableObject> keep) where T : OpenXRSettings
    {
        var settings = New<T>(keep);
        settings.m_renderMode = 0;
        settings.m_depthSubmissionMode = 2;
        settings.features = [null, .. Features.Select(id => Feature(keep, id))];
        return settings;
    }

    static OpenXRFeature Feature(Func<ScriptableObject, ScriptableObject> keep, string id)
    {
        var feature = New<OpenXRFeature>(keep);
        feature.featureIdInternal = id;
        feature.m_enabled = false;
        return feature;
    }

    static T New<T>(Func<ScriptableObject, ScriptableObject> keep) where T : ScriptableObject => (T)keep(ScriptableObject.CreateInstance<T>());

    public sealed class OpenXRPackageSettings : ScriptableObject
    {
        public List<BuildTargetGroup> Keys;
        public List<OpenXRSettings> Values;
    }

    public class OpenXRSettings : ScriptableObject
    {
        public List<OpenXRFeature> features;
        public int m_renderMode;
        public int m_depthSubmissionMode;
    }

    public sealed class NewOpenXRSettings : OpenXRSettings
    {
        public int m_latencyOptimization = 1;
    }

    public sealed class OpenXRFeature : ScriptableObject
    {
        public string featureIdInternal;
        public bool m_enabled;
    }
}
