using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Setup
{
    /// <summary>Reads and changes the OpenXR settings of a player in the settings asset of the OpenXR package.</summary>
    /// <remarks>
    /// Uses the serialised field names in "OpenXR Package Settings.asset" of com.unity.xr.openxr 1.13: m_renderMode, m_depthSubmissionMode, and
    /// features with the fields featureIdInternal and m_enabled.
    /// </remarks>
    static class OpenXrOptions
    {
        const string SettingsType = "OpenXRPackageSettings";

        /// <summary>Returns whether the project has OpenXR settings for a player.</summary>
        public static bool Exist(BuildTargetGroup player) => PlayerAsset.Find(SettingsType, player) != null;

        /// <summary>Returns whether a feature is enabled; null if the project has no such settings or no such feature.</summary>
        public static bool? IsOn(BuildTargetGroup player, string featureId)
        {
            var feature = Feature(player, featureId);
            if (feature == null) return null;
            using (var serialised = new SerializedObject(feature)) return serialised.FindProperty("m_enabled")?.boolValue;
        }

        /// <summary>Enables a feature.</summary>
        /// <returns>False if the project has no such feature.</returns>
        public static bool TurnOn(BuildTargetGroup player, string featureId)
        {
            var feature = Feature(player, featureId);
            if (feature == null) return false;
            using (var serialised = new SerializedObject(feature))
            {
                var enabled = serialised.FindProperty("m_enabled");
                if (enabled == null) return false;
                enabled.boolValue = true;
                serialised.ApplyModifiedProperties();
                return true;
            }
        }

        /// <summary>Returns the number of an enumeration setting; null if the project has no such setting.</summary>
        public static int? Get(BuildTargetGroup player, string field)
        {
            var settings = PlayerAsset.Find(SettingsType, player);
            if (settings == null) return null;
            using (var serialised = new SerializedObject(settings)) return serialised.FindProperty(field)?.intValue;
        }

        /// <summary>Sets an enumeration setting to a number.</summary>
        /// <returns>False if the project has no such setting.</returns>
        public static bool Set(BuildTargetGroup player, string field, int value)
        {
            var settings = PlayerAsset.Find(SettingsType, player);
            if (settings == null) return false;
            using (var serialised = new SerializedObject(settings))
            {
                var property = serialised.FindProperty(field);
                if (property == null) return false;
                property.intValue = value;
                serialised.ApplyModifiedProperties();
                return true;
            }
        }

        static Object Feature(BuildTargetGroup player, string id)
        {
            var settings = PlayerAsset.Find(SettingsType, player);
            if (settings == null) return null;
            using (var serialised = new SerializedObject(settings))
            {
                var features = serialised.FindProperty("features");
                for (var i = 0; i < (features?.arraySize ?? 0); i++)
                {
                    var feature = features.GetArrayElementAtIndex(i).objectReferenceValue;
                    if (feature != null && IdOf(feature) == id) return feature;
                }
                return null;
            }
        }

        static string IdOf(Object feature)
        {
            using (var serialised = new SerializedObject(feature)) return serialised.FindProperty("featureIdInternal")?.stringValue;
        }
    }
}
