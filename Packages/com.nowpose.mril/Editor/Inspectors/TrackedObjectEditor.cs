using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(TrackedObject))]
    [CanEditMultipleObjects]
    sealed class TrackedObjectEditor : LiveInspector<TrackedObject>
    {
        // Does not offer to change a prefab asset, because Unity can add objects to a prefab only while the prefab is open.
        protected override void DrawAlways()
        {
            if (Application.isPlaying || EditorUtility.IsPersistent(target) || Target.Shows == RigPose.Held) return;
            if (GUILayout.Button(InspectorTexts.AddGhost)) ObjectGhost.AddTo(Target);
        }

        protected override void DrawLive()
        {
            EditorGUILayout.LabelField("Parent", Target.Parent ?? LiveText.Unknown);
            EditorGUILayout.LabelField("State", Target.Fault ?? "current");
            EditorGUILayout.LabelField("Gap", LiveText.Mm(1000 * Target.GapMetres));
        }
    }
}
