using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Setup
{
    /// <summary>Reads and writes project settings for which Unity has no API, by the names of their serialised fields.</summary>
    static class ProjectAssets
    {
        const string Player = "ProjectSettings/ProjectSettings.asset", Graphics = "ProjectSettings/GraphicsSettings.asset";
        const string Handling = "activeInputHandler";

        // The editor keeps the state of its session until it ends.
        const string HasChangedHandling = "Nowpose.HasChangedInputHandling";

        /// <summary>Number of the setting Active Input Handling; null if the setting is not found.</summary>
        public static int? InputHandling => SerialisedField.Read(AssetAt(Player), Handling, property => (int?)property.intValue);

        /// <summary>Whether the number was set since Unity was started. It takes effect when Unity is started again.</summary>
        public static bool IsInputHandlingPending => SessionState.GetBool(HasChangedHandling, false);

        /// <summary>Type name of the default render pipeline asset; null for the built-in pipeline.</summary>
        public static string DefaultRenderPipeline
        {
            get
            {
                var asset = SerialisedField.Referenced<Object>(AssetAt(Graphics), "m_CustomRenderPipeline");
                return asset == null ? null : asset.GetType().Name;
            }
        }

        /// <summary>Sets Active Input Handling to a number.</summary>
        /// <returns>False if the setting is not found.</returns>
        public static bool ChooseInputHandling(int value)
        {
            var isFound = SerialisedField.Write(AssetAt(Player), Handling, property => property.intValue = value);
            if (isFound) SessionState.SetBool(HasChangedHandling, true);
            return isFound;
        }

        static Object AssetAt(string path) => AssetDatabase.LoadAllAssetsAtPath(path).FirstOrDefault();
    }
}
