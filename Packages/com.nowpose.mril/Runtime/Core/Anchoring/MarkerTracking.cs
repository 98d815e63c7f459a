namespace Nowpose.Anchoring
{
    /// <summary>Quality of a marker's pose according to its source.</summary>
    public enum MarkerTracking
    {
        /// <summary>Not tracked: the pose is old or missing.</summary>
        None,

        /// <summary>Known approximately, or remembered.</summary>
        Limited,

        /// <summary>Tracked according to the source; the pose may still be stale, see <see cref="MarkerSighting.LastSeen"/>.</summary>
        Tracking,

        /// <summary>
        /// Placed by hand: the pose is exact by definition and independent of the view. While a person moves it,
        /// <see cref="MarkerSighting.LastSeen"/> advances with time; afterwards it is the time at which the marker was released.
        /// </summary>
        Placed,
    }
}
