namespace Nowpose.Latency
{
    /// <summary>Who shows a code. The marks in its ring tell them apart, so that a picture's two codes are never mixed up.</summary>
    enum CodeKind
    {
        /// <summary>The control system, by LEDs or by a monitor: C1(t_VLC) of Eq. (7).</summary>
        Control,

        /// <summary>The headset, by a hologram: C2(t_MR) of Eq. (7), mapped to the control clock.</summary>
        Headset,
    }
}
