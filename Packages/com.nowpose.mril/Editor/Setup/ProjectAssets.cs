using System;
using UnityEditor;

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
        public static int? InputHandling => Read(Player, Handling, property => (int?)property.intValue);

        /// <summary>Whether the number was set since Unity was started. It takes effect when Unity is started again.</summary>
        public static bool IsInputHandlingPending => SessionState.GetBool(HasChangedHandling, false);

        /// <summary>Type name of the default render pipeline asset; null for the built-in pipeline.</summary>
        public static string DefaultRenderPipeline => Read(Graphics, "m_CustomRenderPipeline", TypeOfReferenced);

        /// <summary>Sets Active Input Handling to a number.</summary>
        /// <returns>False if the setting is not found.</returns>
        public static bool ChooseInputHandling(int value) => Read(Player, Handling, property =>
        {
            property.intValue = value;
            property.serializedObject.ApplyModifiedProperties();
            SessionState.SetBool(HasChangedHandling, true);
            return true;
        });

        static string TypeOfReferenced(SerializedProperty property)
        {
            var asset = property.objectReferenceValue;
            return asset == null ? null : asset.GetType().Name;
        }

        static T Read<T>(string path, string field, Func<SerializedProperty, T> read)
        {
            var all = AssetDatabase.LoadAllAssetsAtPath(path);
            if (all.Length == 0 || all[0] == null) return default;
            using (var serialised = new SerializedObject(all[0]))
            {
                var property = serialised.FindProperty(field);
                return property == null ? default : read(property);
            }
        }
    }
}
