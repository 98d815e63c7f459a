using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>
    /// Holds places in the room by the device's own map, and keeps them over restarts. Belongs to the frame's thread; never
    /// throws.
    /// </summary>
    interface ISpatialAnchors
    {
        /// <summary>Whether it is known by now which anchors were kept. False for ever where the device keeps none.</summary>
        bool IsReady { get; }

        /// <summary>Begins to hold a place; returns at once. Disposing the anchor lets go of it, not of what is kept.</summary>
        /// <param name="pose">In the room frame.</param>
        ISpatialAnchor Hold(in RigidTransform pose);

        /// <summary>
        /// What was kept under a name in this run or before; returns at once. Null when there is none, or while not <see
        /// cref="IsReady"/>.
        /// </summary>
        ISpatialAnchor Find(string name);

        /// <summary>Keeps nothing under a name any more. Does nothing when nothing is.</summary>
        void Forget(string name);
    }
}
