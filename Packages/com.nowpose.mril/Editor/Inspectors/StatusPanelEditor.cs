using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(StatusPanel))]
    [CanEditMultipleObjects]
    sealed class StatusPanelEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var panel = (StatusPanel)target;
            if (!panel.isActiveAndEnabled)
            {
                EditorGUILayout.LabelField("Shows", InspectorTexts.Disabled);
                return;
            }
            EditorGUILayout.LabelField(InspectorTexts.LegibleUpTo, LiveText.Number(panel.LegibleMetres, "0.0", " m"));
            StatusLines.Draw(panel.Texts);
        }
    }
}
