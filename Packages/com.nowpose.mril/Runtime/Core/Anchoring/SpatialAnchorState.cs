namespace Nowpose.Anchoring
{
    /// <summary>Whether the device holds a position.</summary>
    public enum SpatialAnchorState
    {
        /// <summary>Requested; the device has not answered yet.</summary>
        Pending,

        /// <summary>The device holds the position, and its pose is known.</summary>
        Tracking,

        /// <summary>The device holds the position, but its pose is currently unknown, for example in the dark or in another room.</summary>
        Lost,

        /// <summary>The device does not hold the position; see <see cref="ISpatialAnchor.Problem"/>. Final state.</summary>
        Failed,
    }
}
