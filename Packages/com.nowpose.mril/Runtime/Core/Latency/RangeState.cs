namespace Nowpose.Latency
{
    /// <summary>Whether L_visu is the calibrated one: the render time stands in the constant-latency range or beyond it.</summary>
    /// <remarks>Schnierle &amp; Röck 2022, Fig. 11b.</remarks>
    public enum RangeState
    {
        /// <summary>Cannot be told; <see cref="RangeDoubt"/> has the reason. L_visu is taken as calibrated.</summary>
        Unknown,

        /// <summary>L_visu is constant.</summary>
        Inside,

        /// <summary>Frames miss the display's refresh: L_visu is longer than calibrated, by nobody knows how much.</summary>
        Outside,
    }
}
