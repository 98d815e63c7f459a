using Nowpose.Kinematics;
using Nowpose.Session;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>
    /// Places objects in the frame <c>world</c> of the cell. The transform of this frame is the Base Anchor above the object. Without such an
    /// anchor, it is the Base Anchor below the session; if there is none either, the session's object.
    /// </summary>
    static class CellPlace
    {
        public static Transform WorldOf(Component component, MrilSession session)
        {
            var anchor = AnchorOf(component, session);
            return anchor != null ? anchor.transform : session.transform;
        }

        /// <summary>Returns the Base Anchor above a component, or else that below its session; null if there is none.</summary>
        /// <param name="session">Session of the component; null if it has none.</param>
        public static BaseAnchor AnchorOf(Component component, MrilSession session)
        {
            var anchor = component.GetComponentInParent<BaseAnchor>();
            return anchor == null && session != null ? session.GetComponentInChildren<BaseAnchor>(includeInactive: true) : anchor;
        }

        /// <summary>Returns the state of a displayed pose. Without the frame <c>world</c>, the object stays where it was, so it is held.</summary>
        /// <param name="world">The transform of the frame; equal to null if it was destroyed.</param>
        /// <param name="state">State of the pose in this frame.</param>
        public static PoseState StateIn(Transform world, PoseState state) => world == null && state > PoseState.Held ? PoseState.Held : state;

        /// <summary>Returns the pose of an object in the frame <c>world</c>, right-handed, in metres.</summary>
        public static RigidTransform PoseIn(Transform world, Transform placed) => UnityPoses.ToRoom(
            world.InverseTransformPoint(placed.position), Quaternion.Inverse(world.rotation) * placed.rotation);

        /// <summary>Converts a displacement in metres to the units of an object's parent, which differ below a scaled model.</summary>
        /// <param name="metres">Displacement in the parent's axes.</param>
        /// <param name="world">Transform whose units are metres, such as the frame <c>world</c> or a rig.</param>
        public static Vector3 InUnitsOfParent(this Vector3 metres, Transform moved, Transform world)
        {
            if (moved.parent == null) return metres;
            var (one, unit) = (world.lossyScale, moved.parent.lossyScale);
            return new Vector3(Ratio(metres.x * one.x, unit.x), Ratio(metres.y * one.y, unit.y), Ratio(metres.z * one.z, unit.z));
        }

        // Along an axis that is scaled to 0, every displacement is invisible.
        static float Ratio(float length, float unit) => unit == 0 ? 0 : length / unit;

        /// <summary>Moves an object to a pose in the frame <c>world</c>.</summary>
        /// <param name="pose">Pose in the frame <c>world</c>, right-handed, in metres.</param>
        public static void PlaceIn(this Transform moved, Transform world, in RigidTransform pose)
        {
            var place = UnityFrame.ToUnity(pose);
            moved.SetPositionAndRotation(world.TransformPoint(place.Position()), world.rotation * place.Rotation());
        }
    }
}
