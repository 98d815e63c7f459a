using System;

namespace Nowpose.Latency.Reprojection
{
    /// <summary>Names of reprojection modes in files, diagnostics and messages.</summary>
    static class ReprojectionModeNames
    {
        static readonly string[] Names = { "unknown", "none", "orientation_only", "planar_manual", "planar_from_depth", "depth" };

        public static string NameOf(ReprojectionMode mode) => Names[(int)mode];

        /// <param name="name">Exactly as written by <see cref="NameOf"/>.</param>
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
