using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>A position in the room that the device holds in its own map. Use it on the frame loop's thread only; never throws.</summary>
    public interface ISpatialAnchor : IDisposable
    {
        SpatialAnchorState State { get; }

        /// <summary>
        /// Current pose in the room frame, including the device's corrections of its map. While tracking is lost, it is the last pose. Null before
        /// the first pose.
        /// </summary>
        RigidTransform? Pose { get; }

        /// <summary>Name under which the anchor is stored across restarts; null when it is not stored.</summary>
        string KeptAs { get; }

        /// <summary>Reason why the anchor is not held or not stored, in one line; null if nothing is wrong.</summary>
        string Problem { get; }

        /// <summary>
        /// Stores the anchor under a name as soon as the device holds it, in place of an anchor stored under this name earlier. Returns immediately.
        /// </summary>
        void Keep(string name);
    }

    /// <summary>Whether the device holds a position.</summary>
    public enum SpatialAnchorState
    {
        /// <summary>The position is requested; the device has not responded yet.</summary>
        Pending,

        /// <summary>The device holds the position, and its pose is known.</summary>
        Tracking,

        /// <summary>The device holds the position, but its pose is currently unknown, for example in the dark or in another room.</summary>
        Lost,

        /// <summary>The device does not hold the position; see <see cref="ISpatialAnchor.Problem"/>. This state is final.</summary>
        Failed,
    }
}
