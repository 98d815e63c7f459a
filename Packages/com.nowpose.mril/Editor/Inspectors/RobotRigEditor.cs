using Nowpose.Kinematics;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor
{
    [CustomEditor(typeof(RobotRig))]
    [CanEditMultipleObjects]
    sealed class RobotRigEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var rig = (RobotRig)target;
            if (rig.Model == null)
            {
                EditorGUILayout.LabelField("Robot", LiveText.Unknown);
                return;
            }
            EditorGUILayout.LabelField("Robot", rig.Model.Name);
            for (var i = 0; i < rig.Joints.Length; i++) EditorGUILayout.LabelField(rig.Model.MovingJoints[i].Name, Position(rig, i));
        }

        static string Position(RobotRig rig, int joint) => rig.Model.MovingJoints[joint].Kind == JointKind.Prismatic
            ? LiveText.Number(1000 * rig.Joints[joint], "0.0", " mm")
            : LiveText.Number(rig.Joints[joint] * Mathf.Rad2Deg, "0.0", "°");
    }
}
