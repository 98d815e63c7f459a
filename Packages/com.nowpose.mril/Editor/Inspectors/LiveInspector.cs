using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>An inspector with the component's fields, its missing references and, in play mode, its live values.</summary>
    abstract class LiveInspector : UnityEditor.Editor
    {
        public sealed override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            DrawShortcomings();
            if (targets.Length == 1) DrawAlways();
            if (!Application.isPlaying) return;
            EditorGUILayout.Space();
            if (targets.Length == 1) DrawLive();
            else EditorGUILayout.HelpBox(InspectorTexts.OneObject, MessageType.Info);
        }

        public override bool RequiresConstantRepaint() => Application.isPlaying && targets.Length == 1;

        protected virtual void OnEnable() => EditorApplication.update += Sample;

        protected virtual void OnDisable() => EditorApplication.update -= Sample;

        /// <summary>Draws rows and controls that are also available outside play mode; called only if one object is selected.</summary>
        protected virtual void DrawAlways() { }

        /// <summary>Draws the current values; called only in play mode and if one object is selected.</summary>
        protected virtual void DrawLive() { }

        /// <summary>Records the plotted values; called often in play mode, even while the inspector is not drawn.</summary>
        /// <param name="time">Time since the editor's start, in s.</param>
        protected virtual void Sample(double time) { }

        void Sample()
        {
            if (Application.isPlaying && target != null) Sample(EditorApplication.timeSinceStartup);
        }

        void DrawShortcomings()
        {
            Shortcoming clicked = null;
            foreach (var shortcoming in Shortcomings.Of(targets))
            {
                EditorGUILayout.HelpBox(shortcoming.Message, MessageType.Warning);
                if (shortcoming.FixLabel != null && GUILayout.Button(shortcoming.FixLabel)) clicked = shortcoming;
            }
            // Delayed to the end, because the controls must stay the same within one event.
            clicked?.Fix();
        }
    }
}
