using System.Collections.Generic;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// The component that moves a drawn part to the pose of the session: the gripper that contains the part, otherwise the rig that contains it. An
    /// object of the cell has its own place, so its parts have no carrier above it.
    /// </summary>
    sealed class PoseCarrier
    {
        readonly RobotRig _rig;
        readonly VirtualGripper _gripper;
        readonly GameObject _owner;
        bool _wasFollowing, _wasShifted;

        PoseCarrier(RobotRig rig, VirtualGripper gripper, GameObject owner)
        {
            _rig = rig;
            _gripper = gripper;
            _owner = owner;
            (_wasFollowing, _wasShifted) = (IsFollowing, IsShifted);
        }

        /// <summary>Whether the component follows the session; false if it was destroyed.</summary>
        public bool IsFollowing => IsGripper
            ? _gripper != null && _gripper.Flange != null && _gripper.Rig != null && _gripper.Rig.IsFollowing
            : _rig != null && _rig.IsFollowing;

        /// <summary>Whether a calibration by eye has shifted the rig away from the robot.</summary>
        public bool IsShifted => (IsGripper ? _gripper != null ? _gripper.Rig : null : _rig) is RobotRig rig && rig != null && rig.Shift != Vector3.zero;

        /// <summary>Whether the component's object is active in the scene.</summary>
        public bool IsActive => _owner != null && _owner.activeInHierarchy;

        /// <summary>
        /// Returns the look of a part. While its carrier does not follow the session, the part is at an old pose. It hardly fades while it is shifted,
        /// because the user must compare the displayed robot with the real robot.
        /// </summary>
        public PoseLook Over(PoseLook look) => IsFollowing ? IsShifted ? look.Also(PoseMessages.Shifted, PoseMessages.ShiftedByEye, 0) : look
            : IsGripper ? look.With(PoseMessages.GripperNotMoved, PoseMessages.GripperUnattached)
            : look.With(PoseMessages.RigNotMoved, PoseMessages.RigDisabled);

        bool IsGripper => _gripper is object;

        bool IsDestroyed => IsGripper ? _gripper == null : _rig == null;

        /// <summary>Finds the carrier of a part.</summary>
        /// <param name="before">Result of the last call for this part; null at the first call.</param>
        /// <returns>The carrier; null if the part has none. A carrier that was destroyed and not replaced is still returned.</returns>
        public static PoseCarrier Of(Transform part, PoseCarrier before)
        {
            var found = Above(part);
            // Keeps a carrier that was destroyed and not replaced, because its parts are still visible but no longer current.
            var isLeft = before != null && before.IsDestroyed && (found == null || before.IsGripper && !found.IsGripper);
            return isLeft ? before : found;
        }

        public bool IsSameAs(PoseCarrier other) => ReferenceEquals(_rig, other._rig) && ReferenceEquals(_gripper, other._gripper);

        /// <summary>Returns whether the component has started or stopped following the session, or being shifted, since the last call.</summary>
        public bool HasChanged()
        {
            var (isFollowing, isShifted) = (IsFollowing, IsShifted);
            var hasChanged = isFollowing != _wasFollowing || isShifted != _wasShifted;
            (_wasFollowing, _wasShifted) = (isFollowing, isShifted);
            return hasChanged;
        }

        static PoseCarrier Above(Transform part)
        {
            for (var at = part; at != null; at = at.parent)
            {
                if (at.TryGetComponent<VirtualGripper>(out var gripper)) return new PoseCarrier(null, gripper, at.gameObject);
                if (at.TryGetComponent<RobotRig>(out var rig)) return new PoseCarrier(rig, null, at.gameObject);
                if (at.TryGetComponent<ICellObject>(out _)) return null;
            }
            return null;
        }
    }

    /// <summary>The different carriers of the parts of an appearance.</summary>
    sealed class PoseCarriers
    {
        readonly List<PoseCarrier> _all = new List<PoseCarrier>();

        /// <summary>
        /// Returns the look of the parts: that of the first active carrier (rig before gripper) that does not follow the session, or else of the first one
        /// that is shifted.
        /// </summary>
        public PoseLook Over(PoseLook look)
        {
            foreach (var carrier in _all)
                if (carrier.IsActive && !carrier.IsFollowing) return carrier.Over(look);
            foreach (var carrier in _all)
                if (carrier.IsActive && carrier.IsShifted) return carrier.Over(look);
            return look;
        }

        public void Clear() => _all.Clear();

        /// <param name="carrier">The carrier of a part; null if it has none.</param>
        public void Add(PoseCarrier carrier)
        {
            if (carrier == null) return;
            foreach (var known in _all)
                if (known.IsSameAs(carrier)) return;
            _all.Add(carrier);
        }

        /// <summary>Returns whether a carrier has started or stopped following the session, or being shifted, since the last call.</summary>
        public bool Update()
        {
            var hasChanged = false;
            foreach (var carrier in _all) hasChanged |= carrier.HasChanged();
            return hasChanged;
        }
    }
}
