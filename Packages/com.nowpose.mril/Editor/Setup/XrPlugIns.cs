using System.Linq;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Setup
{
    /// <summary>Reads, from the settings asset of XR Plug-in Management, which XR plug-ins a player starts.</summary>
    /// <remarks>Uses the serialised field names in XRGeneralSettings.asset: m_LoaderManagerInstance and m_Loaders.</remarks>
    static class XrPlugIns
    {
        const string SettingsType = "XRGeneralSettingsPerBuildTarget";
        const string LoaderType = "OpenXRLoaderBase";

        /// <summary>Returns whether a player starts OpenXR; null if the project has no XR settings for the player.</summary>
        public static bool? UseOpenXr(BuildTargetGroup player) =>
            HasOpenXr(SerialisedField.Referenced<Object>(PlayerAsset.Find(SettingsType, player), "m_LoaderManagerInstance"));

        static bool? HasOpenXr(Object manager) =>
            SerialisedField.Read(manager, "m_Loaders", loaders => (bool?)SerialisedField.References(loaders).Any(IsOpenXr));

        // The UWP player uses OpenXRLoaderNoPreInit, and other players use OpenXRLoader. OpenXRLoaderBase is their common base class.
        static bool IsOpenXr(Object loader)
        {
            for (var type = loader == null ? null : loader.GetType(); type != null; type = type.BaseType)
                if (type.Name == LoaderType) return true;
            return false;
        }
    }
}
