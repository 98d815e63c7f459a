using System.Linq;
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
        public static bool? IsOn(BuildTargetGroup player, string featureId) =>
            SerialisedField.Read(Feature(player, featureId), "m_enabled", property => (bool?)property.boolValue);

        /// <summary>Enables a feature.</summary>
        /// <returns>False if the project has no such feature.</returns>
        public static bool TurnOn(BuildTargetGroup player, string featureId) =>
            SerialisedField.Write(Feature(player, featureId), "m_enabled", property => property.boolValue = true);

        /// <summary>Returns the number of an enumeration setting; null if the project has no such setting.</summary>
        public static int? Get(BuildTargetGroup player, string field) =>
            SerialisedField.Read(PlayerAsset.Find(SettingsType, player), field, property => (int?)property.intValue);

        /// <summary>Sets an enumeration setting to a number.</summary>
        /// <returns>False if the project has no such setting.</returns>
        public static bool Set(BuildTargetGroup player, string field, int value) =>
            SerialisedField.Write(PlayerAsset.Find(SettingsType, player), field, property => property.intValue = value);

        static Object Feature(BuildTargetGroup player, string id) => SerialisedField.Read(
            PlayerAsset.Find(SettingsType, player), "features",
            features => SerialisedField.References(features).FirstOrDefault(feature => feature != null && IdOf(feature) == id));

        static string IdOf(Object feature) => SerialisedField.Read(feature, "featureIdInternal", property => property.stringValue);
    }
}
