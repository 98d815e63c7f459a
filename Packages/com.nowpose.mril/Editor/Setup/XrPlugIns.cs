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
        const string LoaderType = "OpenXRLoaderBase";

        /// <summary>Null where the project has no settings for that player.</summary>
        public static bool? UseOpenXr(BuildTargetGroup player)
        {
            foreach (var guid in AssetDatabase.FindAssets("t:" + SettingsType))
            {
                var all = AssetDatabase.LoadMainAssetAtPath(AssetDatabase.GUIDToAssetPath(guid));
                var isOpenXr = HasOpenXr(Referenced(SettingsOf(all, player), "m_LoaderManagerInstance"));
                if (isOpenXr != null) return isOpenXr;
            }
            return null;
        }

        static Object SettingsOf(Object all, BuildTargetGroup player)
        {
            if (all == null) return null;
            using (var serialised = new SerializedObject(all))
            {
                var keys = serialised.FindProperty("Keys");
                var values = serialised.FindProperty("Values");
                if (keys == null || values == null) return null;
                for (var i = 0; i < Math.Min(keys.arraySize, values.arraySize); i++)
                    if (keys.GetArrayElementAtIndex(i).intValue == (int)player) return values.GetArrayElementAtIndex(i).objectReferenceValue;
                return null;
            }
        }

        static Object Referenced(Object owner, string property)
        {
            if (owner == null) return null;
            using (var serialised = new SerializedObject(owner)) return serialised.FindProperty(property)?.objectReferenceValue;
        }

        static bool? HasOpenXr(Object manager)
        {
            if (manager == null) return null;
            using (var serialised = new SerializedObject(manager))
            {
                var loaders = serialised.FindProperty("m_Loaders");
                if (loaders == null) return null;
                return Enumerable.Range(0, loaders.arraySize).Any(i => IsOpenXr(loaders.GetArrayElementAtIndex(i).objectReferenceValue));
            }
        }

        // The UWP player's is OpenXRLoaderNoPreInit, other players' OpenXRLoader; this is the base that they have in common.
        static bool IsOpenXr(Object loader)
        {
            for (var type = loader == null ? null : loader.GetType(); type != null; type = type.BaseType)
                if (type.Name == LoaderType) return true;
            return false;
        }
    }
}
