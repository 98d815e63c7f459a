using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Cell;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>
    /// Rule that no other component moves the object of an actuated part. Outside play mode, rigs and grippers have no robot, so the rule reads the
    /// descriptions and searches for the names of links.
    /// </summary>
    sealed class OneMoverRule : IShortcomingRule
    {
        readonly DescriptionReader _described = new DescriptionReader();

        public bool IsBrokenBy(Component component) =>
            component is ActuatedPart && !EditorUtility.IsPersistent(component) && MessageOf(component) != null;

        public Shortcoming Shortcoming(Component component) => new Shortcoming(MessageOf(component), null, null);

        string MessageOf(Component part)
        {
            if (part.TryGetComponent<ICellObject>(out _)) return ShortcomingTexts.MovedByObject;
            var rig = part.gameObject.GetComponentInParent<RobotRig>(true);
            if (JointOf(rig, part) is RobotJoint moving) return ShortcomingTexts.MovedByJoint(rig.name, moving.Name);
            var gripper = part.gameObject.GetComponentInParent<VirtualGripper>(true);
            var joint = gripper == null ? null : JointOf(gripper, part.transform);
            return joint == null ? null : ShortcomingTexts.MovedByGripper(gripper.name, joint.Name);
        }

        RobotJoint JointOf(RobotRig rig, Component part)
        {
            var model = ModelOf(rig);
            var link = model?.IndexOfLink(part.name) ?? -1;
            if (link < 0 || !rig.HasLinksOf(model)) return null;
            var joint = model.Links[link].ParentJoint;
            return joint == null || joint.Kind == JointKind.Fixed ? null : joint;
        }

        RobotJoint JointOf(VirtualGripper gripper, Transform moved)
        {
            var finger = gripper.Fingers.FirstOrDefault(each => each.Finger == moved);
            var model = finger == null ? null : ModelOf(RigOf(gripper));
            var index = model?.IndexOfMovingJoint(finger.Joint) ?? -1;
            return index < 0 ? null : model.MovingJoints[index];
        }

        static RobotRig RigOf(VirtualGripper gripper)
        {
            var assigned = SerialisedField.Referenced<RobotRig>(gripper, "_rig");
            return assigned != null ? assigned : gripper.gameObject.GetComponentInParent<RobotRig>(true);
        }

        RobotModel ModelOf(RobotRig rig)
        {
            if (rig == null) return null;
            if (rig.Model != null) return rig.Model;
            if (rig.RobotNamespace.Length == 0)
            {
                var session = SceneSearch.SessionOf(rig);
                return session == null ? null : _described.Of(session.RobotAsset);
            }
            return _described.Of(SerialisedField.Referenced<RobotDescriptionAsset>(rig, "_description"));
        }
    }
}
