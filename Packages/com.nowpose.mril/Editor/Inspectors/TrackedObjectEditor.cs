using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(TrackedObject))]
    [CanEditMultipleObjects]
    sealed class TrackedObjectEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var shown = (TrackedObject)target;
            EditorGUILayout.LabelField("Parent", shown.Parent ?? LiveText.Unknown);
            EditorGUILayout.LabelField("State", shown.Fault ?? "current");
            EditorGUILayout.LabelField("Gap", LiveText.Mm(1000 * shown.GapMetres));
        }
    }
}
