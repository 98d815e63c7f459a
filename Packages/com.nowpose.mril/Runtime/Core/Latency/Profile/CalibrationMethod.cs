namespace Nowpose.Latency.Profile
{
    /// <summary>Method that determined L_visu. The members are ordered from the most to the least accurate.</summary>
    enum CalibrationMethod
    {
        /// <summary>Pictures that show the codes of both clocks, Schnierle &amp; Röck 2022, Eq. (7).</summary>
        VisibleLight,

        /// <summary>Delay of the ghost behind the robot during a sinusoidal motion, measured with a camera.</summary>
        Sine,

        /// <summary>By eye: a user shifted the ghost until it agreed with the robot, during forward and backward motion.</summary>
        Nudge,

        /// <summary>L_visu was entered by a user.</summary>
        Manual,
    }
}
