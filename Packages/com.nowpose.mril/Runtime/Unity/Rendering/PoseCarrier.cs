using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>The object that moves a drawn part to the session's pose: the gripper that contains it, else the rig.</summary>
    sealed class PoseCarrier
    {
        readonly RobotRig _rig;
        readonly VirtualGripper _gripper;
        readonly GameObject _owner;
        bool _wasFollowing;

        PoseCarrier(RobotRig rig, VirtualGripper gripper, GameObject owner)
        {
            _rig = rig;
            _gripper = gripper;
            _owner = owner;
            _wasFollowing = IsFollowing;
        }

        /// <summary>Whether it follows the session; false if it was destroyed.</summary>
        public bool IsFollowing => IsGripper
            ? _gripper != null && _gripper.Flange != null && _gripper.Rig != null && _gripper.Rig.IsFollowing
            : _rig != null && _rig.IsFollowing;

        /// <summary>Whether its parts are active in the scene.</summary>
        public bool IsActive => _owner != null && _owner.activeInHierarchy;

        /// <summary>Returns the look while it does not follow the session: its parts stay at an old pose, which may be anywhere.</summary>
        public PoseLook Unmoved(PoseLook look) => IsGripper
            ? look.With("gripper not moved", PoseMessages.GripperUnattached)
            : look.With("rig not moved", PoseMessages.RigDisabled);

        bool IsGripper => _gripper is object;

        bool IsDestroyed => IsGripper ? _gripper == null : _rig == null;

        /// <param name="before">Carrier of the part at the last call; null for none.</param>
        /// <returns>Null if the part never had a carrier.</returns>
        public static PoseCarrier Of(Transform part, PoseCarrier before)
        {
            var found = Above(part);
            // A destroyed carrier without successor stays responsible: its parts are still visible, and not current.
            var isLeft = before != null && before.IsDestroyed && (found == null || before.IsGripper && !found.IsGripper);
            return isLeft ? before : found;
        }

        public bool IsSameAs(PoseCarrier other) => ReferenceEquals(_rig, other._rig) && ReferenceEquals(_gripper, other._gripper);

        /// <returns>Whether it has started or stopped following since the last call.</returns>
        public bool HasTurned()
        {
            var isFollowing = IsFollowing;
            var hasTurned = isFollowing != _wasFollowing;
            _wasFollowing = isFollowing;
            return hasTurned;
        }

        static PoseCarrier Above(Transform part)
        {
            for (var at = part; at != null; at = at.parent)
            {
                if (at.TryGetComponent<VirtualGripper>(out var gripper)) return new PoseCarrier(null, gripper, at.gameObject);
                if (at.TryGetComponent<RobotRig>(out var rig)) return new PoseCarrier(rig, null, at.gameObject);
            }
            return null;
        }
    }
}
