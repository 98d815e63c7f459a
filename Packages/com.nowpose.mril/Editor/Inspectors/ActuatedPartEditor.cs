using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(ActuatedPart))]
    [CanEditMultipleObjects]
    sealed class ActuatedPartEditor : LiveInspector<ActuatedPart>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField(InspectorTexts.StrokeShare, LiveText.Number(100 * Target.Share, "0", " %"));
            EditorGUILayout.LabelField("State", Target.Fault ?? "current");
        }
    }
}
