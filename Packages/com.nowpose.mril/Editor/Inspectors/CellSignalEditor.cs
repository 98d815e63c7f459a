using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(CellSignal))]
    [CanEditMultipleObjects]
    sealed class CellSignalEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var shown = (CellSignal)target;
            var session = shown.Follower?.Source;
            EditorGUILayout.LabelField("Value", LiveText.WithSince(LiveText.Number(shown.Value, "0.###", ""), shown.Since, session));
            EditorGUILayout.LabelField("State", LiveText.WithSince(shown.Fault ?? "current", shown.Follower?.FaultSince, session));
        }
    }
}
