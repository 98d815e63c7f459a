namespace Nowpose.Latency
{
    /// <summary>Reason why a <see cref="RangeState"/> is unknown.</summary>
    enum RangeUnknownReason
    {
        /// <summary>The state is known.</summary>
        None,

        /// <summary>Neither the settings nor a calibration contain a limit.</summary>
        NoLimit,

        /// <summary>The render time is not measured.</summary>
        NoRenderTime,

        /// <summary>Too few frames were measured with the current source.</summary>
        TooFewFrames,

        /// <summary>The limit was found with another source of the render time and does not apply to this one.</summary>
        OtherSource,

        /// <summary>The render time is beyond the calibrated range, and the calibration found no limit in it.</summary>
        BeyondMeasured,
    }
}
