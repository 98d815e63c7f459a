using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(PlannedPath))]
    [CanEditMultipleObjects]
    sealed class PlannedPathEditor : LiveInspector<PlannedPath>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField(
                InspectorTexts.DrawnAhead, Target.DrawnSeconds > 0 ? LiveText.Number(Target.DrawnSeconds, "0.00", " s") : "nothing");
            EditorGUILayout.LabelField("State", Target.Fault ?? "drawn");
        }
    }
}
