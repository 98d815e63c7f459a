using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(LatencyProfileLoader))]
    [CanEditMultipleObjects]
    sealed class LatencyProfileLoaderEditor : LiveInspector<LatencyProfileLoader>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField("Profile", Target.Profile == null ? InspectorTexts.NoProfile : LatencyProfileMessages.Of(Target.Profile));
            EditorGUILayout.LabelField("From", Target.From ?? "–");
            if (Target.Problem != null) EditorGUILayout.HelpBox(Target.Problem, MessageType.Warning);
            if (GUILayout.Button(InspectorTexts.FindProfile)) Target.Reload();
        }
    }
}
