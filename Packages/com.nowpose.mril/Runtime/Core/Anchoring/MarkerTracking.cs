namespace Nowpose.Anchoring
{
    /// <summary>How far a source trusts the pose it gives for a marker.</summary>
    public enum MarkerTracking
    {
        /// <summary>Not followed: the pose is an old one, or none.</summary>
        None,

        /// <summary>Known roughly, or remembered.</summary>
        Limited,

        /// <summary>Followed, as the source says; its pose may be stale all the same, which <see cref="MarkerSighting.LastSeen"/> tells.</summary>
        Tracking,

        /// <summary>
        /// Put there by hand: it is where it was meant to be, whoever looks from wherever, and stays. While somebody moves it,
        /// <see cref="MarkerSighting.LastSeen"/> goes on with the time; afterwards it is the moment at which it was put down.
        /// </summary>
        Placed,
    }
}
