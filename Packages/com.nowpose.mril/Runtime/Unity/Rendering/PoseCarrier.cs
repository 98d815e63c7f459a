using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>What brings something drawn to where the session says: the gripper it is part of, else the rig.</summary>
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

        /// <summary>Whether it does so; what was destroyed does not.</summary>
        public bool IsFollowing => IsGripper
            ? _gripper != null && _gripper.Flange != null && _gripper.Rig != null && _gripper.Rig.IsFollowing
            : _rig != null && _rig.IsFollowing;

        /// <summary>Whether what it carries is there to be seen.</summary>
        public bool IsActive => _owner != null && _owner.activeInHierarchy;

        /// <summary>What is said while it does not follow: what it carries stands wherever it was, and that may be anywhere.</summary>
        public PoseLook Unmoved(PoseLook look) => IsGripper
            ? look.Saying("gripper not moved", "the gripper is disabled or rides on no link of a rig that is moved")
            : look.Saying("rig not moved", "the rig is disabled or cannot show the robot");

        bool IsGripper => _gripper is object;

        bool IsDestroyed => IsGripper ? _gripper == null : _rig == null;

        /// <param name="before">What carried it when last asked; null for nothing.</param>
        /// <returns>Null where nothing does, and nothing ever did.</returns>
        public static PoseCarrier Of(Transform part, PoseCarrier before)
        {
            var found = Above(part);
            // Nobody has taken the place of one that is gone: what it left still stands there, and is not current.
            var isLeft = before != null && before.IsDestroyed && (found == null || before.IsGripper && !found.IsGripper);
            return isLeft ? before : found;
        }

        public bool IsSameAs(PoseCarrier other) => ReferenceEquals(_rig, other._rig) && ReferenceEquals(_gripper, other._gripper);

        /// <returns>Whether it begins or ceases to follow, since this was asked last.</returns>
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
