namespace Nowpose.Anchoring
{
    /// <summary>State of the position of the robot's base.</summary>
    public enum BaseAnchorState
    {
        /// <summary>A person or a script has placed the base; markers do not move it.</summary>
        Placed,

        /// <summary>The markers have not yet determined the position.</summary>
        Searching,

        /// <summary>The position of an earlier run, as the device stored it; not yet confirmed by a marker.</summary>
        Restored,

        /// <summary>The markers have determined the position.</summary>
        Locked,

        /// <summary>A marker has moved relative to the base: either the marker or the robot was moved. The base stays in its position.</summary>
        Moved,

        /// <summary>The device has lost the stored position; the base stays in its last position.</summary>
        Lost,
    }
}
