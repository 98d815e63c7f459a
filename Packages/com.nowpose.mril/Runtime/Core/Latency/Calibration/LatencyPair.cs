using System;

namespace Nowpose.Latency
{
    /// <summary>One picture of a calibration: how long the frame rendered, and how late its light was.</summary>
    public readonly struct LatencyPair
    {
        /// <param name="renderMs">Δt_render: above 0 to 1000 ms. Zero is what drivers report that do not measure.</param>
        /// <param name="visuMs">L_visu by Eq. (7): −1000 to 1000 ms; misread pictures may make it negative.</param>
        /// <exception cref="InputException">Out of range, or not a number.</exception>
        public LatencyPair(double renderMs, double visuMs)
        {
            RenderMs = SettingRange.Require(renderMs, LeastRenderMs, GreatestMs, "render_ms", "ms");
            VisuMs = SettingRange.Require(visuMs, -GreatestMs, GreatestMs, "visu_ms", "ms");
        }

        const double LeastRenderMs = 0.001, GreatestMs = 1000;

        /// <summary>Whether it is a render time that was measured, ms.</summary>
        public static bool IsRenderMs(double renderMs) => renderMs >= LeastRenderMs && renderMs <= GreatestMs;

        public double RenderMs { get; }

        public double VisuMs { get; }
    }
}
