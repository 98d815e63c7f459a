using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Render time and visualisation latency of one picture of a calibration.</summary>
readonly struct LatencyPair
{
    /// <summary>Maximum absolute value, ms. Codes repeat after this time, so a misread picture can be wrong by the same amount.</summary>
    const double MaxVisuMs = TimestampCode.PeriodMs;

    /// <param name="renderMs">A measured render time, see <see cref="MeasuredRenderTime"/>.</param>
    /// <param name="visuMs">L_visu by Eq. (7), −65 536 to 65 536 ms. A misread picture can have any value in this range.</param>
    /// <exception cref="InputException">A value is out of range or not a number.</exception>
    public LatencyPair(double renderMs, double visuMs)
    {
        RenderMs = MeasuredRenderTime.RequireMs(renderMs);
        VisuMs = SettingRange.Require(visuMs, -MaxVisuMs, MaxVisuMs, "visu_ms", "ms");
    }

    public double RenderMs { get; }

    public double VisuMs { get; }
}
