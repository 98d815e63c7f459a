using System;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Setup
{
    /// <summary>Finds the settings object of one player in an asset of another package. The asset contains one object per player.</summary>
    /// <remarks>
    /// This assembly does not reference the packages that own these assets, so it reads the assets by the names of their fields Keys and Values.
    /// </remarks>
    static class PlayerAsset
    {
        /// <summary>Finds the settings object of a player.</summary>
        /// <param name="type">Type name of the asset.</param>
        /// <returns>Null if no such asset exists, or if it contains no object for the player.</returns>
        public static Object Find(string type, BuildTargetGroup player)
        {
            foreach (var guid in AssetDatabase.FindAssets("t:" + type))
            {
                var found = In(AssetDatabase.LoadMainAssetAtPath(AssetDatabase.GUIDToAssetPath(guid)), player);
                if (found != null) return found;
            }
            return null;
        }

        static Object In(Object all, BuildTargetGroup player)
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
    }
}
