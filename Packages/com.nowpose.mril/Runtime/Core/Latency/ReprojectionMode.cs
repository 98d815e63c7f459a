namespace Nowpose.Latency
{
    /// <summary>Method by which the display shifts a finished frame to the newest head pose (late-stage reprojection).</summary>
    public enum ReprojectionMode
    {
        /// <summary>The mode is not reported.</summary>
        Unknown = 0,

        /// <summary>The frame is shown without correction.</summary>
        None,

        /// <summary>Corrects the rotation of the head only.</summary>
        OrientationOnly,

        /// <summary>Corrects rotation and translation of the head for one plane, which the application sets.</summary>
        PlanarManual,

        /// <summary>Corrects rotation and translation of the head for one plane, which the runtime fits to the depth buffer.</summary>
        PlanarFromDepth,

        /// <summary>Corrects rotation and translation of the head for each pixel, using the depth buffer.</summary>
        Depth,
    }
}
