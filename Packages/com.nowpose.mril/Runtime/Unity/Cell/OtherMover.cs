using Nowpose.Kinematics;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>Finds a component that already moves the object of an actuated part. Two components must not move one object.</summary>
    static class OtherMover
    {
        /// <summary>Returns the component that moves the object of a part, with the joint. Does not allocate.</summary>
        /// <returns>
        /// An object of the cell, without a joint; or a rig or a gripper, with the joint that moves the object; null if no component moves it.
        /// </returns>
        public static (Component Mover, RobotJoint Joint) Of(Component part)
        {
            if (part.TryGetComponent<ICellObject>(out var shown)) return ((Component)shown, null);
            var rig = part.GetComponentInParent<RobotRig>();
            if (rig != null && JointOf(rig, part.transform) is RobotJoint moving) return (rig, moving);
            var gripper = part.GetComponentInParent<VirtualGripper>();
            return gripper != null && gripper.JointOf(part.transform) is RobotJoint joint ? (gripper, joint) : default;
        }

        /// <summary>Returns the message to the user about a part and another mover, in one line; null without another mover.</summary>
        public static string Conflict(Component mover, RobotJoint joint)
        {
            if (mover is null) return null;
            if (joint == null) return ObjectMessages.OtherMover;
            return mover is RobotRig ? ObjectMessages.MovedByJoint(mover.name, joint.Name) : ObjectMessages.MovedByGripper(mover.name, joint.Name);
        }

        static RobotJoint JointOf(RobotRig rig, Transform moved)
        {
            var link = rig.LinkAbove(moved, out var place);
            if (link < 0 || place != moved) return null;
            var joint = rig.Model.Links[link].ParentJoint;
            return joint == null || joint.Kind == JointKind.Fixed ? null : joint;
        }
    }
}
