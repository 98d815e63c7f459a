using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>An inspector that shows the fields of a component, its missing references and, in play mode, its live values.</summary>
    /// <typeparam name="T">Type of the component.</typeparam>
    abstract class LiveInspector<T> : UnityEditor.Editor where T : Component
    {
        /// <summary>The component; the first one if several objects are selected.</summary>
        protected T Target => (T)target;

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

        /// <summary>Draws rows and controls that are also available outside play mode. Called only if exactly one object is selected.</summary>
        protected virtual void DrawAlways() { }

        /// <summary>Draws the current values. Called only in play mode and if exactly one object is selected.</summary>
        protected virtual void DrawLive() { }

        /// <summary>Records values for charts. Called many times per second in play mode, even while the inspector is not drawn.</summary>
        /// <param name="time">Time since the start of the editor in s.</param>
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
            // The fix is applied after all controls are drawn, because the number of controls must not change within one event.
            clicked?.Fix();
        }
    }
}
