using System;

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

    /// <summary>Names of reprojection modes in files, diagnostics and messages.</summary>
    static class ReprojectionModeNames
    {
        static readonly string[] Names = { "unknown", "none", "orientation_only", "planar_manual", "planar_from_depth", "depth" };

        public static string NameOf(ReprojectionMode mode) => Names[(int)mode];

        /// <param name="name">Name exactly as returned by <see cref="NameOf"/>.</param>
        /// <param name="mode"><see cref="ReprojectionMode.Unknown"/> when the method returns false.</param>
        public static bool TryParse(string name, out ReprojectionMode mode)
        {
            var index = Array.IndexOf(Names, name);
            mode = index < 0 ? ReprojectionMode.Unknown : (ReprojectionMode)index;
            return index >= 0;
        }

        /// <summary>All names, separated by commas, for messages.</summary>
        public static string All => string.Join(", ", Names);
    }
}
