using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>
    /// Lets the device hold positions in the room in its own map, and store them across restarts. Use it on the frame loop's thread only; never
    /// throws.
    /// </summary>
    interface ISpatialAnchors
    {
        /// <summary>Whether the stored anchors have been loaded. Always false on a device that has no anchor store.</summary>
        bool IsReady { get; }

        /// <summary>Starts to hold a position, and returns at once. Disposing the anchor releases it but does not remove a stored anchor.</summary>
        /// <param name="pose">Pose in the room frame.</param>
        ISpatialAnchor Hold(in RigidTransform pose);

        /// <summary>
        /// Returns the anchor that was stored under a name in this run or an earlier one; null if there is none, or while
        /// <see cref="IsReady"/> is false. Returns at once.
        /// </summary>
        ISpatialAnchor Find(string name);

        /// <summary>Removes the anchor stored under a name, if there is one.</summary>
        void Forget(string name);
    }
}
