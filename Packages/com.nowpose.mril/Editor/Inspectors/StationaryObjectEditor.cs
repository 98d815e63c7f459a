using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Cell;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(StationaryObject))]
    [CanEditMultipleObjects]
    sealed class StationaryObjectEditor : LiveInspector<StationaryObject>
    {
        protected override void DrawLive()
        {
            var followed = Target.Followed;
            EditorGUILayout.LabelField(InspectorTexts.MovedByHand, Target.IsMoving ? "now" : "no");
            EditorGUILayout.LabelField("Parent", followed?.Parent ?? LiveText.Unknown);
            EditorGUILayout.LabelField(InspectorTexts.PoseFrom, followed?.Origin ?? LiveText.Unknown);
            if (followed?.IsKnown == true) DrawPose(followed.World, Target.transform);
            EditorGUILayout.LabelField("State", LiveText.WithSince(Target.Fault ?? "current", followed?.FaultSince, followed?.Source));
        }

        static void DrawPose(Transform world, Transform shown)
        {
            var pose = CellPlace.PoseIn(world, shown);
            EditorGUILayout.LabelField(InspectorTexts.ObjectPosition, LiveText.Place(pose.X, pose.Y, pose.Z));
            EditorGUILayout.LabelField(InspectorTexts.ObjectRotation, LiveText.TurnToLeft(Quaternion.Inverse(world.rotation) * shown.rotation));
        }
    }
}
