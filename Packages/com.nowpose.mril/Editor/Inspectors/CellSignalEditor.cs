using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(CellSignal))]
    [CanEditMultipleObjects]
    sealed class CellSignalEditor : LiveInspector<CellSignal>
    {
        protected override void DrawLive()
        {
            var session = Target.Follower?.Source;
            EditorGUILayout.LabelField("Value", LiveText.WithSince(LiveText.Number(Target.Value, "0.###", ""), Target.Since, session));
            EditorGUILayout.LabelField("State", LiveText.WithSince(Target.Fault ?? "current", Target.Follower?.FaultSince, session));
        }
    }
}
