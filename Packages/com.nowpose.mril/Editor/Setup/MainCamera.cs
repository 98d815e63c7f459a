using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Setup
{
    /// <summary>Reads and changes the main camera of the open scenes. The user can undo changes; Unity saves them with the scene.</summary>
    static class MainCamera
    {
        /// <summary>Whether the camera clears to black with alpha 0; null if the open scenes have no enabled main camera.</summary>
        public static bool? ClearsToTransparentBlack
        {
            get
            {
                var camera = Camera.main;
                if (camera == null) return null;
                return camera.clearFlags == CameraClearFlags.SolidColor && camera.backgroundColor == Color.clear;
            }
        }

        /// <summary>Distance of the near clip plane in metres; null if the open scenes have no enabled main camera.</summary>
        public static float? NearClipMetres
        {
            get => Camera.main == null ? (float?)null : Camera.main.nearClipPlane;
            set
            {
                if (Camera.main == null || value == null) return;
                Undo.RecordObject(Camera.main, "Near clip plane");
                Camera.main.nearClipPlane = value.Value;
                PrefabUtility.RecordPrefabInstancePropertyModifications(Camera.main);
            }
        }

        public static void ClearToTransparentBlack()
        {
            if (Camera.main == null) return;
            Undo.RecordObject(Camera.main, CheckTitles.UndoClear);
            Camera.main.clearFlags = CameraClearFlags.SolidColor;
            Camera.main.backgroundColor = Color.clear;
            PrefabUtility.RecordPrefabInstancePropertyModifications(Camera.main);
        }
    }
}
