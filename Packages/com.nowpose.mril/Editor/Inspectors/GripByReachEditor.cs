using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(GripByReach))]
    [CanEditMultipleObjects]
    sealed class GripByReachEditor : LiveInspector<GripByReach>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField("Holds", Target.Held ?? (Target.Fault == null ? "nothing" : "unknown"));
            EditorGUILayout.LabelField("State", Target.Fault ?? "current");
        }
    }
}
