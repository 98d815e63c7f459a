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
            EditorGUILayout.LabelField("Value", LiveText.Number(shown.Value, "0.###", ""));
            EditorGUILayout.LabelField("State", shown.Fault ?? "current");
        }
    }
}
