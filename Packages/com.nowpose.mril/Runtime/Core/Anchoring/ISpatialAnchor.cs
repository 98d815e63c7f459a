using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>A place in the room that the device holds by its own map. Belongs to the frame's thread; never throws.</summary>
    public interface ISpatialAnchor : IDisposable
    {
        SpatialAnchorState State { get; }

        /// <summary>
        /// Where it is in the room frame now, as the device corrects its map; what it was last while lost, null before it was
        /// known.
        /// </summary>
        RigidTransform? Pose { get; }

        /// <summary>The name under which it survives the application; null while it does not.</summary>
        string KeptAs { get; }

        /// <summary>Why it is not held, or not kept, in one line; null when nothing is wrong.</summary>
        string Problem { get; }

        /// <summary>Keeps it under a name once it is held, in place of what was kept under it; returns at once.</summary>
        void Keep(string name);
    }
}
