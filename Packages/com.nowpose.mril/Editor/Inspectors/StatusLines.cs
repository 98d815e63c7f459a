using Nowpose.Unity;
using Nowpose.Unity.Status;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Draws the rows of a status panel as rows of an inspector.</summary>
    static class StatusLines
    {
        public static void Draw(StatusTexts texts)
        {
            for (var row = StatusRow.Pose; row < StatusRow.Message; row++)
                if (texts.IsShown(row)) EditorGUILayout.LabelField(texts.LabelOf(row), Joined(texts.ValueOf(row), texts.NoteOf(row)));
            if (texts.ValueOf(StatusRow.Message).Length > 0) EditorGUILayout.HelpBox(texts.ValueOf(StatusRow.Message), MessageType.Warning);
        }

        static string Joined(string value, string note) => note.Length == 0 ? value : value + ", " + note;
    }
}
