using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(TrackedObject))]
    [CanEditMultipleObjects]
    sealed class TrackedObjectEditor : LiveInspector
    {
        // Does not offer to change a prefab asset, because Unity can add objects to a prefab only while the prefab is open.
        protected override void DrawAlways()
        {
            var shown = (TrackedObject)target;
            if (Application.isPlaying || EditorUtility.IsPersistent(target) || shown.Shows == RigPose.Held) return;
            if (GUILayout.Button(InspectorTexts.AddGhost)) ObjectGhost.AddTo(shown);
        }

        protected override void DrawLive()
        {
            var shown = (TrackedObject)target;
            EditorGUILayout.LabelField("Parent", shown.Parent ?? LiveText.Unknown);
            EditorGUILayout.LabelField("State", shown.Fault ?? "current");
            EditorGUILayout.LabelField("Gap", LiveText.Mm(1000 * shown.GapMetres));
        }
    }
}
