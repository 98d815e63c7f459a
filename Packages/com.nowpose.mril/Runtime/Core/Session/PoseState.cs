namespace Nowpose.Session
{
    /// <summary>Whether the displayed pose is the robot's present one. Anything but <see cref="Current"/> must look different.</summary>
    public enum PoseState
    {
        /// <summary>No sample of the arm has arrived yet; the pose is the robot's zero pose.</summary>
        NoData,

        /// <summary>The headset clock is unsynchronised: the newest samples are shown as they arrive, uncompensated.</summary>
        Unsynchronised,

        /// <summary>A joint between base and tool is held: its samples are older than the horizon cap, or too few to predict from.</summary>
        Held,

        /// <summary>Every joint between base and tool is predicted to, or interpolated at, the moment of light.</summary>
        Current,
    }
}
