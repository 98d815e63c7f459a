using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Shows the buttons of the headset's consent prompt, and a button that reads a code from the clipboard.</summary>
    [CustomEditor(typeof(CellPairing))]
    sealed class CellPairingEditor : LiveInspector<CellPairing>
    {
        protected override void DrawLive()
        {
            if (!Target.isActiveAndEnabled)
            {
                EditorGUILayout.LabelField("Pairs", InspectorTexts.Disabled);
                return;
            }
            // Reads the cell only once, because a button may change it, and the number of controls must not change within one event.
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
