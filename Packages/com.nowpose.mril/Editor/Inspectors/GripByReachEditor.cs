using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(GripByReach))]
    [CanEditMultipleObjects]
    sealed class GripByReachEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var shown = (GripByReach)target;
            EditorGUILayout.LabelField("Holds", shown.Held ?? (shown.Fault == null ? "nothing" : "unknown"));
            EditorGUILayout.LabelField("State", shown.Fault ?? "current");
        }
    }
}
