using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(LatencyProfileLoader))]
    [CanEditMultipleObjects]
    sealed class LatencyProfileLoaderEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var loader = (LatencyProfileLoader)target;
            EditorGUILayout.LabelField("Profile", loader.Profile == null ? InspectorTexts.NoProfile : LatencyProfileMessages.Of(loader.Profile));
            EditorGUILayout.LabelField("From", loader.From ?? "–");
            if (loader.Problem != null) EditorGUILayout.HelpBox(loader.Problem, MessageType.Warning);
            if (GUILayout.Button(InspectorTexts.FindProfile)) loader.Reload();
        }
    }
}
