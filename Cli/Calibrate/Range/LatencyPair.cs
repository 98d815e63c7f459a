namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Render time and visualisation latency of one picture of a calibration.</summary>
/// <param name="RenderMs">A measured render time, see <see cref="Nowpose.Latency.MeasuredRenderTime"/>.</param>
/// <param name="VisuMs">L_visu by Eq. (7). A misread picture can have any value between −65 536 and 65 536 ms.</param>
readonly record struct LatencyPair(double RenderMs, double VisuMs);
