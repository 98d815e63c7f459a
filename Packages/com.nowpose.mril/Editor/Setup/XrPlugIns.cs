using System;
using System.Linq;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor
{
    /// <summary>Reads which XR plug-ins a player starts from the settings asset of XR Plug-in Management.</summary>
    /// <remarks>
    /// That package is not referenced, so its assets are read by the names of their serialised fields, which stand in every
    /// project's XRGeneralSettings.asset: Keys and Values, m_LoaderManagerInstance, m_Loaders.
    /// </remarks>
    static class XrPlugIns
    {
        const string SettingsType = "XRGeneralSettingsPerBuildTarget";
        const string LoaderType = "OpenXRLoader";

        /// <summary>Null where the project has no settings for that player.</summary>
        public static bool? UseOpenXr(BuildTargetGroup player)
        {
            foreach (var guid in AssetDatabase.FindAssets("t:" + SettingsType))
            {
                var all = AssetDatabase.LoadMainAssetAtPath(AssetDatabase.GUIDToAssetPath(guid));
                var loaders = Property(Referenced(SettingsOf(all, player), "m_LoaderManagerInstance"), "m_Loaders");
                if (loaders != null) return Enumerable.Range(0, loaders.arraySize).Any(i => IsOpenXr(loaders.GetArrayElementAtIndex(i)));
            }
            return null;
        }

        static Object SettingsOf(Object all, BuildTargetGroup player)
        {
            var keys = Property(all, "Keys");
            var values = Property(all, "Values");
            if (keys == null || values == null) return null;
            for (var i = 0; i < Math.Min(keys.arraySize, values.arraySize); i++)
                if (keys.GetArrayElementAtIndex(i).intValue == (int)player) return values.GetArrayElementAtIndex(i).objectReferenceValue;
            return null;
        }

        static Object Referenced(Object owner, string property) => Property(owner, property)?.objectReferenceValue;

        static SerializedProperty Property(Object owner, string name) => owner == null ? null : new SerializedObject(owner).FindProperty(name);

        // One of the classes derived from it starts without an early initialisation.
        static bool IsOpenXr(SerializedProperty loader)
        {
            for (var type = loader.objectReferenceValue == null ? null : loader.objectReferenceValue.GetType(); type != null; type = type.BaseType)
                if (type.Name == LoaderType) return true;
            return false;
        }
    }
}
