namespace Nowpose.Anchoring
{
    /// <summary>Whether the device holds a place.</summary>
    public enum SpatialAnchorState
    {
        /// <summary>It has been asked to; nothing is known yet.</summary>
        Pending,

        /// <summary>It holds it, and knows where it is.</summary>
        Tracking,

        /// <summary>It holds it, and does not know where it is at the moment: too dark, another room.</summary>
        Lost,

        /// <summary>It does not; <see cref="ISpatialAnchor.Problem"/> says why. Final.</summary>
        Failed,
    }
}
