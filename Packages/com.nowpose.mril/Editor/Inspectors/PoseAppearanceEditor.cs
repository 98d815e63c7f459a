using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Rendering;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(PoseAppearance))]
    [CanEditMultipleObjects]
    sealed class PoseAppearanceEditor : LiveInspector<PoseAppearance>
    {
        protected override void DrawLive()
        {
            var look = Target.Look;
            EditorGUILayout.LabelField("Shown", look.Label.Length == 0 ? "unchanged" : look.Label);
            EditorGUILayout.LabelField("Reason", Target.isActiveAndEnabled ? look.Reason : InspectorTexts.ComponentDisabled);
            EditorGUILayout.LabelField("Drawn", Target.IsDrawn ? Manner(look) : "nothing");
            EditorGUILayout.LabelField("Parts", Target.PartCount.ToString());
        }

        static string Manner(in PoseLook look) => look.IsHatched ? InspectorTexts.Striped(LiveText.Number(look.Fade, "0.0", "")) : "plain";
    }
}
