namespace Nowpose.Latency
{
    /// <summary>Whether L_visu has its calibrated value: whether the render time is in the constant-latency range.</summary>
    /// <remarks>Schnierle &amp; Röck 2022, Fig. 11b.</remarks>
    public enum RangeState
    {
        /// <summary>Cannot be determined; <see cref="RangeUnknownReason"/> has the reason. The calibrated L_visu is used.</summary>
        Unknown,

        /// <summary>L_visu is constant.</summary>
        Inside,

        /// <summary>Frames miss the display's refresh: L_visu is longer than calibrated, by an unknown amount.</summary>
        Outside,
    }
}
