using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(SessionRecording))]
    [CanEditMultipleObjects]
    sealed class SessionRecordingEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var recording = (SessionRecording)target;
            EditorGUILayout.LabelField("State", recording.IsRecording ? "recording" : recording.Problem ?? InspectorTexts.NotRecording);
            EditorGUILayout.LabelField("File", recording.Path ?? LiveText.Unknown);
        }
    }
}
