using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>An inspector with the component's fields, what it lacks, and in play mode its live values.</summary>
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
            else EditorGUILayout.HelpBox("Live values are shown for one object at a time.", MessageType.Info);
        }

        public override bool RequiresConstantRepaint() => Application.isPlaying && targets.Length == 1;

        protected virtual void OnEnable() => EditorApplication.update += Sample;

        protected virtual void OnDisable() => EditorApplication.update -= Sample;

        /// <summary>What is shown and can be done also while nothing plays; with one object only.</summary>
        protected virtual void DrawAlways() { }

        /// <summary>Values now, in play mode and with one object only.</summary>
        protected virtual void DrawLive() { }

        /// <summary>Takes what is plotted; called often in play mode, also while nothing is drawn.</summary>
        /// <param name="time">Seconds.</param>
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
            // Only now: what is drawn must stay the same within one event.
            clicked?.Fix();
        }
    }
}
