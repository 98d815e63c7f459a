using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Offers the controls of the headset's prompt, and reads codes without a camera.</summary>
    [CustomEditor(typeof(CellPairing))]
    sealed class CellPairingEditor : LiveInspector
    {
        CellPairing Target => (CellPairing)target;

        protected override void DrawLive()
        {
            if (!Target.isActiveAndEnabled)
            {
                EditorGUILayout.LabelField("Pairs", InspectorTexts.Disabled);
                return;
            }
            // Read once: a button changes it, and the controls must stay the same within one event.
            var cell = Target.Cell;
            EditorGUILayout.LabelField("Cell", cell ?? "–");
            EditorGUILayout.HelpBox(Target.Words, Target.Problem == null ? MessageType.Info : MessageType.Warning);
            if (Target.Question != null) DrawAnswers();
            if (GUILayout.Button(InspectorTexts.ReadClipboard)) Target.ReadCode(EditorGUIUtility.systemCopyBuffer);
            if (cell != null && GUILayout.Button("Forget the cell")) Target.Forget();
        }

        void DrawAnswers()
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button("Accept")) Target.Accept();
                if (GUILayout.Button("Refuse")) Target.Refuse();
            }
        }
    }
}
