namespace Nowpose.Latency
{
    /// <summary>Why a <see cref="RangeState"/> is unknown.</summary>
    enum RangeDoubt
    {
        /// <summary>It is known.</summary>
        None,

        /// <summary>Neither settings nor calibration have a limit.</summary>
        NoLimit,

        /// <summary>Nothing measures the render time.</summary>
        NoRenderTime,

        /// <summary>Too few frames were measured with the present source.</summary>
        TooFewFrames,

        /// <summary>The limit was found with another source of the render time, so it means nothing for this one.</summary>
        OtherSource,

        /// <summary>The render time is beyond all that was calibrated, and no limit was found up to there.</summary>
        BeyondMeasured,
    }
}
