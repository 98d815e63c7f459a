namespace Nowpose.Latency.Sweep
{
    /// <summary>Whether the render time from a source depends on the load of the GPU.</summary>
    enum LoadSight
    {
        /// <summary>The sweep has too few loads or render times for a decision.</summary>
        Unclear,

        /// <summary>The render time grows with the load.</summary>
        Seen,

        /// <summary>The render time does not grow with the load: this source can neither find nor monitor a limit.</summary>
        Unseen,
    }
}
