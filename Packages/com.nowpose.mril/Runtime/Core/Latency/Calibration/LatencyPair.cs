using Nowpose.Latency;

namespace Nowpose.Latency.Calibration
{
    /// <summary>One picture of a calibration: how long the frame rendered, and how late its light was.</summary>
    readonly struct LatencyPair
    {
        /// <summary>A code begins anew after so long, ms: a misread picture may be off by as much, and is the fit's to leave out.</summary>
        const double GreatestVisuMs = TimestampCode.PeriodMs;

        /// <param name="renderMs">A <see cref="MeasuredRenderTime"/>.</param>
        /// <param name="visuMs">L_visu by Eq. (7): −65 536 to 65 536 ms, of a misread picture anything in it.</param>
        /// <exception cref="InputException">Out of range, or not a number.</exception>
        public LatencyPair(double renderMs, double visuMs)
        {
            RenderMs = MeasuredRenderTime.RequireMs(renderMs);
            VisuMs = SettingRange.Require(visuMs, -GreatestVisuMs, GreatestVisuMs, "visu_ms", "ms");
        }

        public double RenderMs { get; }

        public double VisuMs { get; }
    }
}
