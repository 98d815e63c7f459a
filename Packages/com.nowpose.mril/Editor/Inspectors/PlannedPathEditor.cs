using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(PlannedPath))]
    [CanEditMultipleObjects]
    sealed class PlannedPathEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var shown = (PlannedPath)target;
            EditorGUILayout.LabelField(InspectorTexts.DrawnAhead, shown.DrawnSeconds > 0 ? LiveText.Number(shown.DrawnSeconds, "0.00", " s") : "nothing");
            EditorGUILayout.LabelField("State", shown.Fault ?? "drawn");
        }
    }
}
