namespace Nowpose.Latency.Profile
{
    /// <summary>Method that determined L_visu, from the most to the least accurate.</summary>
    enum CalibrationMethod
    {
        /// <summary>Pictures of the codes of both clocks, Schnierle &amp; Röck 2022, Eq. (7).</summary>
        VisibleLight,

        /// <summary>Delay of the ghost behind the robot in a sine jog, measured by a camera.</summary>
        Sine,

        /// <summary>By eye: the ghost was shifted until it agreed with the robot, forward and backward.</summary>
        Nudge,

        /// <summary>Entered by a user.</summary>
        Manual,
    }
}
