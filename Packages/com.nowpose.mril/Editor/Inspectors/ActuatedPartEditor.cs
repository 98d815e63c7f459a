using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(ActuatedPart))]
    [CanEditMultipleObjects]
    sealed class ActuatedPartEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var shown = (ActuatedPart)target;
            EditorGUILayout.LabelField(InspectorTexts.StrokeShare, LiveText.Number(100 * shown.Share, "0", " %"));
            EditorGUILayout.LabelField("State", shown.Fault ?? "current");
        }
    }
}
