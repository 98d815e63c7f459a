using System;

namespace Nowpose.Messages
{
    /// <summary>Messages about the result of a load sweep, and error messages about load sweeps.</summary>
    static class SweepMessages
    {
        public const string NotMeasured =
            "no component measured the render time, so the limit cannot be determined; add a Render Time Source to the session";

        public static string Rise(double lowVertices, double highVertices, string source, double lowMs, double highMs) =>
            FormattableString.Invariant($"from about {lowVertices:0} to {highVertices:0} vertices, {source} went from {lowMs:0.00} to ")
            + FormattableString.Invariant($"{highMs:0.00} ms");

        public static string Responds(string rise) => $"this source responds to load: {rise}";

        public static string NoResponse(string rise, double neededMs, string advice) =>
            FormattableString.Invariant($"this source does not respond to load: {rise}; the increase must be at least {neededMs:0.00} ms; {advice}");

        public const string MeasureGpu =
            "it does not measure the GPU; switch on Frame Timing Stats in the player settings, or use a device that reports GPU times, and "
            + "sweep again";

        public const string IncreaseLoad = "keep the load in view, increase the maximum load, and sweep again";

        public static string LogNotWritten(string path, string reason) =>
            $"sweep log {path} cannot be written: {reason}; check the folder's permissions and free space";

        public const string TimeWithoutSource = "render_ms: its source is missing; a render time needs a source";

        /// <param name="loads">Number of loads with enough render times.</param>
        public static string TooFewData(string source, int loads, int minTimes) =>
            $"too few render times to determine whether {source} responds to load: the number of loads with {minTimes} or more render times is {loads}; "
            + "3 are needed; use more loads or a longer sweep";
    }
}
