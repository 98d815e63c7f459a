using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(SessionRecording))]
    [CanEditMultipleObjects]
    sealed class SessionRecordingEditor : LiveInspector<SessionRecording>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField("State", Target.IsRecording ? "recording" : Target.Problem ?? InspectorTexts.NotRecording);
            EditorGUILayout.LabelField("File", Target.Path ?? LiveText.Unknown);
        }
    }
}
