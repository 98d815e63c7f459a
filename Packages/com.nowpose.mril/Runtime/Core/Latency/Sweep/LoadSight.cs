namespace Nowpose.Latency.Sweep
{
    /// <summary>Whether a source of the render time sees how much the GPU has to draw.</summary>
    enum LoadSight
    {
        /// <summary>The sweep has too few loads or render times to tell.</summary>
        Unclear,

        /// <summary>The render time grows with the load.</summary>
        Seen,

        /// <summary>It does not: no limit can be found with this source, and none can be watched.</summary>
        Unseen,
    }
}
