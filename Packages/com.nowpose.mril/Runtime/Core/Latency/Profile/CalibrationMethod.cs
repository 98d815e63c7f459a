namespace Nowpose.Latency.Profile
{
    /// <summary>How L_visu was found, from the most to the least exact.</summary>
    enum CalibrationMethod
    {
        /// <summary>Pictures of both clocks' codes, Schnierle &amp; Röck 2022, Eq. (7).</summary>
        VisibleLight,

        /// <summary>The ghost's lag behind the robot in a sine jog, seen by a camera.</summary>
        Sine,

        /// <summary>By eye: shifted until ghost and robot agree, forward and backward.</summary>
        Nudge,

        /// <summary>Written down by somebody.</summary>
        Manual,
    }
}
