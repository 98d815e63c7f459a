using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(StationaryObject))]
    [CanEditMultipleObjects]
    sealed class StationaryObjectEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var shown = (StationaryObject)target;
            EditorGUILayout.LabelField(InspectorTexts.MovedByHand, shown.IsMoving ? "now" : "no");
            EditorGUILayout.LabelField("State", shown.Fault ?? "current");
        }
    }
}
