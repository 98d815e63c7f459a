using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(CellActions))]
    [CanEditMultipleObjects]
    sealed class CellActionsEditor : LiveInspector<CellActions>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField(InspectorTexts.ConnectionRequested, Target.IsConnecting ? "yes" : "no");
            EditorGUILayout.LabelField(InspectorTexts.NudgeOfVisu, LiveText.Number(Target.NudgeMs, "0.0", " ms"));
        }
    }
}
