using Nowpose.Session;
using Nowpose.Unity.Cell;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>State that the look of parts in the scene shows. It is the settled state of the component that moves them.</summary>
    /// <remarks>
    /// An object of the cell has its own place, independent of the objects above it in the hierarchy. A rig without a moving base of its own stands on
    /// the object or rig above it, and is therefore never more current than this one. Allocates nothing.
    /// </remarks>
    readonly struct PlacedState
    {
        PlacedState(PoseState pose, BaseAnchor anchor, bool isUnplaced = false) => (Pose, Anchor, IsUnplaced) = (pose, anchor, isUnplaced);

        public PoseState Pose { get; }

        /// <summary>
        /// The anchor that places the parts: that in whose frame the cell gives their pose, or else the one above them. Null if there is none: their
        /// place does not depend on the base.
        /// </summary>
        public BaseAnchor Anchor { get; }

        /// <summary>Whether the parts are on an object that neither the user nor a source has placed.</summary>
        public bool IsUnplaced { get; }

        /// <summary>
        /// Returns the state of the nearest object, rig or gripper at or above a transform. If there is none, returns that of the session's own robot;
        /// for an object with a signal or actuated part, which no robot moves, returns that of the display time.
        /// </summary>
        public static PlacedState Of(Transform parts, DisplayFrame frame, MrilSession source)
        {
            if (IsMoved(parts, out var rig, out var shown)) return rig is object ? Of(rig, frame) : Of(shown);
            var state = IsOfSignal(parts) && source.Session != null ? source.Session.Frames.SettledStateOfTime : source.StateIn(frame);
            return new PlacedState(state, Above(parts));
        }

        /// <summary>Returns the nearest object, rig, gripper or anchor at or above a part and below the root; the root if there is none.</summary>
        public static Transform MoverOf(Transform part, Transform root)
        {
            for (var at = part; at != root; at = at.parent)
                if (RigAt(at) != null || at.TryGetComponent<ICellObject>(out _) || at.TryGetComponent<BaseAnchor>(out _)) return at;
            return root;
        }

        /// <summary>Returns whether the nearest object, rig or gripper at or above a transform shows the newest samples.</summary>
        public static bool IsUncompensated(Transform parts) => IsMoved(parts, out var rig, out var shown)
            && (rig is object ? rig.Shows == RigPose.Held : shown is TrackedObject tracked && tracked.Shows == RigPose.Held);

        // Gets the nearest rig or object at or above a transform: a rig also at its gripper. One of the two is null.
        static bool IsMoved(Transform parts, out RobotRig rig, out ICellObject shown)
        {
            (rig, shown) = (null, null);
            for (var at = parts; at != null; at = at.parent)
            {
                rig = RigAt(at);
                if (rig is object || at.TryGetComponent(out shown)) return true;
            }
            return false;
        }

        static bool IsOfSignal(Transform parts) => parts.TryGetComponent<CellSignal>(out _) || parts.TryGetComponent<ActuatedPart>(out _);

        // A gripper moves with its rig, which may be elsewhere in the hierarchy.
        static RobotRig RigAt(Transform at)
        {
            if (at.TryGetComponent<VirtualGripper>(out var gripper) && gripper.Rig != null) return gripper.Rig;
            return at.TryGetComponent<RobotRig>(out var rig) ? rig : null;
        }

        static PlacedState Of(ICellObject shown) => new PlacedState(shown.SettledState, On(shown.World), shown.IsUnplaced);

        static PlacedState Of(RobotRig rig, DisplayFrame frame)
        {
            var own = rig.StateIn(frame);
            if (rig.Robot?.HasRootFrame == true) return new PlacedState(own, On(rig.World));
            var below = OfBase(rig, frame);
            return new PlacedState(below.Pose < own ? below.Pose : own, below.Anchor, below.IsUnplaced && own != PoseState.Incomplete);
        }

        // The object that moves the base may be the rig's own object.
        static PlacedState OfBase(RobotRig rig, DisplayFrame frame)
        {
            for (var at = rig.transform; at != null; at = at.parent)
            {
                if (at.TryGetComponent<ICellObject>(out var shown)) return Of(shown);
                if (at.TryGetComponent<RobotRig>(out var other) && other != rig)
                    return other.IsFollowing ? Of(other, frame) : new PlacedState(PoseState.Incomplete, Above(at));
            }
            return new PlacedState(PoseState.Current, Above(rig.transform));
        }

        static BaseAnchor Above(Transform parts) => parts.GetComponentInParent<BaseAnchor>(true);

        static BaseAnchor On(Transform world) => world != null && world.TryGetComponent<BaseAnchor>(out var anchor) ? anchor : null;
    }
}
