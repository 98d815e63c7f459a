using System;
using Nowpose.Anchoring;
using Nowpose.Editor.Messages;
using Nowpose.Kinematics;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Shows the pose of the base frame in URDF axes (x forward, y left, z up). Its buttons shift the frame along its own axes.</summary>
    [CustomEditor(typeof(BaseAnchor))]
    [CanEditMultipleObjects]
    sealed class BaseAnchorEditor : LiveInspector<BaseAnchor>
    {
        // Step sizes of the buttons: the smallest changes of a robot's pose that are visible at arm's length.
        const float StepMetres = 0.005f;
        const float StepDegrees = 0.5f;

        protected override void DrawAlways()
        {
            var place = Target.transform;
            var (at, turn) = (place.position, place.rotation);
            var pose = UnityFrame.FromUnity(new UnityPose(at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w));
            var up = turn * Vector3.up;
            EditorGUILayout.LabelField(InspectorTexts.BasePosition, LiveText.Place(pose.X, pose.Y, pose.Z));
            EditorGUILayout.LabelField(InspectorTexts.BaseRotation, LiveText.TurnToLeft(turn));
            EditorGUILayout.LabelField("Tilted", LiveText.Degrees(Math.Atan2(Math.Sqrt(up.x * up.x + up.z * up.z), up.y)));
            DrawSteps("x", "back", "forward", (1, 0, 0));
            DrawSteps("y", "right", "left", (0, 1, 0));
            DrawSteps("z", "down", "up", (0, 0, 1));
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button("0.5° to the right")) Nudge(Vector3.zero, StepDegrees);
                if (GUILayout.Button("0.5° to the left")) Nudge(Vector3.zero, -StepDegrees);
            }
        }

        protected override void DrawLive()
        {
            EditorGUILayout.LabelField("State", Target.State.ToString());
            EditorGUILayout.LabelField("Message", Target.Words);
            if (Target.Tracker == null || Target.State == BaseAnchorState.Placed) return;
            foreach (var (label, value) in BaseRows.Of(Target.Tracker)) EditorGUILayout.LabelField(label, value);
            if (Target.Tracker.Markers.Count > 0 && GUILayout.Button("Lock again")) Target.Relock();
        }

        void DrawSteps(string axis, string less, string more, (double X, double Y, double Z) direction)
        {
            var step = UnityFrame.DirectionToUnity(direction).Vector() * StepMetres;
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button(axis + " − 5 mm, " + less)) Nudge(-step, 0);
                if (GUILayout.Button(axis + " + 5 mm, " + more)) Nudge(step, 0);
            }
        }

        void Nudge(Vector3 metres, float degreesAboutUp)
        {
            Undo.RecordObjects(new Object[] { Target.transform }, "Nudge " + Target.name);
            Target.Nudge(metres, degreesAboutUp);
            if (!Application.isPlaying) PrefabUtility.RecordPrefabInstancePropertyModifications(Target.transform);
        }
    }
}
