using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>
    /// Shows the speed, the shift and the marks. Like a headset menu, its buttons change the shift, add a mark and apply the result.
    /// </summary>
    [CustomEditor(typeof(LatencyNudge))]
    sealed class LatencyNudgeEditor : LiveInspector<LatencyNudge>
    {
        protected override void DrawLive()
        {
            if (!Target.isActiveAndEnabled)
            {
                EditorGUILayout.LabelField("Shifts", InspectorTexts.Disabled);
                return;
            }
            EditorGUILayout.LabelField(InspectorTexts.AxisSpeed, LiveText.Number(Target.SpeedMmPerS, "0", " mm/s") + (Target.IsSteady ? "" : ", not steady"));
            EditorGUILayout.LabelField(InspectorTexts.ShiftedBy, LiveText.Number(Target.OffsetMm, "0.0", " mm"));
            EditorGUILayout.LabelField("Marks", InspectorTexts.Marks(Target.ForwardCount, Target.BackwardCount));
            if (Target.Problem != null) EditorGUILayout.HelpBox(Target.Problem, MessageType.Warning);
            DrawButtons();
        }

        void DrawButtons()
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button("− 1 mm")) Target.Step(-1);
                if (GUILayout.Button("+ 1 mm")) Target.Step(1);
            }
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button("Set mark")) Target.Mark();
                if (GUILayout.Button("Apply")) Target.Apply();
                if (GUILayout.Button("Clear")) Target.Clear();
            }
        }
    }
}
