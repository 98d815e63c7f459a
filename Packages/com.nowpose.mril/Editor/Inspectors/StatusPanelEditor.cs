using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(StatusPanel))]
    [CanEditMultipleObjects]
    sealed class StatusPanelEditor : LiveInspector<StatusPanel>
    {
        protected override void DrawLive()
        {
            if (!Target.isActiveAndEnabled)
            {
                EditorGUILayout.LabelField("Shows", InspectorTexts.Disabled);
                return;
            }
            EditorGUILayout.LabelField(InspectorTexts.LegibleUpTo, LiveText.Number(Target.LegibleMetres, "0.0", " m"));
            StatusLines.Draw(Target.Texts);
        }
    }
}
