namespace Nowpose.Session
{
    /// <summary>Whether the displayed pose is the robot's present one. Anything but <see cref="Current"/> must look different.</summary>
    public enum PoseState
    {
        /// <summary>A joint between base and tool has had no sample yet; it stands at zero.</summary>
        Incomplete,

        /// <summary>
        /// The moment of light is not known well enough: the clock is unsynchronised (the newest samples are shown as they
        /// are), still converging, or in holdover for so long that its error bound exceeds the setting.
        /// </summary>
        Unsynchronised,

        /// <summary>
        /// A joint between base and tool is held: its samples are older than the horizon cap, stamped later than the light, or
        /// too few to predict from. Or the gateway reports that a joint of the robot has no data, which it can know before the samples
        /// are too old.
        /// </summary>
        Held,

        /// <summary>
        /// The render time is outside the constant-latency range, so that the light appears later than calibrated, by nobody
        /// knows how much. The pose is made as a current one is, unless the settings have it held, see
        /// <see cref="OutsideRangeResponse"/>.
        /// </summary>
        OutsideRange,

        /// <summary>
        /// Every joint between base and tool is predicted to, or interpolated at, the moment of light. When the control clock
        /// has just stepped, it takes two sync exchanges until that is doubted.
        /// </summary>
        Current,
    }
}
