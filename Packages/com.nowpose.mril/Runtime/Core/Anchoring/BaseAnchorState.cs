namespace Nowpose.Anchoring
{
    /// <summary>How it is known where the robot's base is.</summary>
    public enum BaseAnchorState
    {
        /// <summary>It stands where a person or a script has put it; no marker moves it.</summary>
        Placed,

        /// <summary>Markers have not said yet where it is.</summary>
        Searching,

        /// <summary>It stands where an earlier run had left it, as the device remembers; no marker has confirmed that yet.</summary>
        Restored,

        /// <summary>Markers have said where it is.</summary>
        Locked,

        /// <summary>A marker is not where it was in relation to the base, which stays where it is: one of the two was moved.</summary>
        Moved,

        /// <summary>The device has lost the place that it held; the base stays where it was last.</summary>
        Lost,
    }
}
