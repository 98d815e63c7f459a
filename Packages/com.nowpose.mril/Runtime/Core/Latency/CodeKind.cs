namespace Nowpose.Latency
{
    /// <summary>The clock that a code shows. Marks in the ring distinguish the two codes of a picture.</summary>
    enum CodeKind
    {
        /// <summary>Shown by the control system, on LEDs or on a monitor: C1(t_VLC) of Eq. (7).</summary>
        Control,

        /// <summary>Shown by the headset as a hologram: C2(t_MR) of Eq. (7), mapped to the control clock.</summary>
        Headset,
    }
}
