using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(CellActions))]
    [CanEditMultipleObjects]
    sealed class CellActionsEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var actions = (CellActions)target;
            EditorGUILayout.LabelField(InspectorTexts.ConnectionRequested, actions.IsConnecting ? "yes" : "no");
            EditorGUILayout.LabelField(InspectorTexts.NudgeOfVisu, LiveText.Number(actions.NudgeMs, "0.0", " ms"));
        }
    }
}
