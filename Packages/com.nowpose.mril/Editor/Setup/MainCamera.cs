using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Setup
{
    /// <summary>Reads and changes the main camera of the open scenes. The user can undo changes; Unity saves them with the scene.</summary>
    /// <remarks>
    /// The CameraSettingsManager of MRTK3's rig overwrites the camera at run time, so its settings for a transparent display apply instead of the camera's.
    /// </remarks>
    static class MainCamera
    {
        const string NearInRig = "transparentDisplay.nearPlaneDistance", ModeInRig = "transparentDisplay.clearMode",
            ColourInRig = "transparentDisplay.clearColor";

        /// <summary>Whether the camera clears to black with alpha 0; null if the open scenes have no enabled main camera.</summary>
        public static bool? ClearsToTransparentBlack
        {
            get
            {
                var camera = Camera.main;
                if (camera == null) return null;
                var rig = RigSettings;
                if (rig == null) return camera.clearFlags == CameraClearFlags.SolidColor && camera.backgroundColor == Color.clear;
                return rig.FindProperty(ModeInRig).intValue == (int)CameraClearFlags.SolidColor && rig.FindProperty(ColourInRig).colorValue == Color.clear;
            }
        }

        /// <summary>Distance of the near clip plane in metres; null if the open scenes have no enabled main camera.</summary>
        public static float? NearClipMetres
        {
            get => Camera.main == null ? (float?)null : RigSettings?.FindProperty(NearInRig).floatValue ?? Camera.main.nearClipPlane;
            set
            {
                if (Camera.main == null || value == null) return;
                var rig = RigSettings;
                if (rig != null)
                {
                    rig.FindProperty(NearInRig).floatValue = value.Value;
                    rig.ApplyModifiedProperties();
                    return;
                }
                Undo.RecordObject(Camera.main, "Near clip plane");
                Camera.main.nearClipPlane = value.Value;
                PrefabUtility.RecordPrefabInstancePropertyModifications(Camera.main);
            }
        }

        public static void ClearToTransparentBlack()
        {
            if (Camera.main == null) return;
            var rig = RigSettings;
            if (rig != null)
            {
                rig.FindProperty(ModeInRig).intValue = (int)CameraClearFlags.SolidColor;
                rig.FindProperty(ColourInRig).colorValue = Color.clear;
                rig.ApplyModifiedProperties();
                return;
            }
            Undo.RecordObject(Camera.main, CheckTitles.UndoClear);
            Camera.main.clearFlags = CameraClearFlags.SolidColor;
            Camera.main.backgroundColor = Color.clear;
            PrefabUtility.RecordPrefabInstancePropertyModifications(Camera.main);
        }

        // Null without MRTK3's rig, or with a version of MRTK3 whose settings have other names.
        static SerializedObject RigSettings
        {
            get
            {
                foreach (var component in Camera.main.transform.root.GetComponentsInChildren<MonoBehaviour>(true))
                {
                    if (component == null || !component.enabled || component.GetType().Name != "CameraSettingsManager") continue;
                    var settings = new SerializedObject(component);
                    var isKnown = settings.FindProperty(NearInRig) != null && settings.FindProperty(ModeInRig) != null && settings.FindProperty(ColourInRig) != null;
                    if (isKnown) return settings;
                }
                return null;
            }
        }
    }
}
