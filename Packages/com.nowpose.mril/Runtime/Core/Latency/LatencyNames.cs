using Nowpose.Latency.Profile;

namespace Nowpose.Latency
{
    /// <summary>The names of the enums of this folder.</summary>
    static class LatencyNames
    {
        public static readonly EnumNames<ReprojectionMode> Reprojection = new EnumNames<ReprojectionMode>(mode => (int)mode);

        /// <summary>The name of <see cref="RenderTimeSourceKind.None"/> is empty.</summary>
        public static readonly EnumNames<RenderTimeSourceKind> RenderTimeSource = new EnumNames<RenderTimeSourceKind>(source => (int)source, "");

        public static readonly EnumNames<CalibrationMethod> CalibrationMethod = new EnumNames<CalibrationMethod>(method => (int)method, "vlc");
        public static readonly EnumNames<RangeState> Range = new EnumNames<RangeState>(range => (int)range);
        public static readonly EnumNames<DepthSubmission> DepthSubmission = new EnumNames<DepthSubmission>(depth => (int)depth);
    }
}
