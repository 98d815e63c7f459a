using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(VirtualGripper))]
    [CanEditMultipleObjects]
    sealed class VirtualGripperEditor : LiveInspector<VirtualGripper>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField(InspectorTexts.AttachedTo, Target.Flange == null ? LiveText.Unknown : Target.Flange.name);
            foreach (var finger in Target.Fingers) EditorGUILayout.LabelField(LabelOf(finger), StateOf(finger, Target.Rig));
        }

        static string LabelOf(GripperFinger finger) => finger.Joint.Length > 0 ? finger.Joint : InspectorTexts.FingerWithoutJoint;

        static string StateOf(GripperFinger finger, RobotRig rig)
        {
            if (rig == null || rig.Model == null) return LiveText.Unknown;
            var index = rig.Model.IndexOfMovingJoint(finger.Joint);
            if (index < 0) return InspectorTexts.NoFingerJoint(rig.Model.Name);
            var joint = rig.Model.MovingJoints[index];
            var position = LiveText.Position(joint, rig.Joints[index]);
            if (finger.Finger == null) return InspectorTexts.NoFinger(position);
            return finger.Finger == rig.Link(joint.ChildLink) ? InspectorTexts.MovedByRig(position) : position;
        }
    }
}
