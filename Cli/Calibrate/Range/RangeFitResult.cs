namespace Nowpose.Cli.Calibrate.Range;

/// <summary>The constant-latency range found by <see cref="RangeFit"/>.</summary>
/// <param name="VisuMs">Mean L_visu within the range, without rejected pairs, ms.</param>
/// <param name="SpreadMs">Standard deviation of L_visu between the individual pictures within the range, ms.</param>
/// <param name="LimitRenderMs">Maximum render time with constant L_visu, ms; null if too few pictures had a higher render time.</param>
/// <param name="ValidToRenderMs">The limit, ms. If there is none, the maximum render time for which a constant L_visu was observed.</param>
/// <param name="Pairs">Total number of pairs.</param>
/// <param name="Used">Number of pairs from which L_visu and its spread were computed: those within the range and on the plateau.</param>
/// <param name="Rejected">
/// Number of pairs within the range but not on the plateau: misread pictures, and frames that waited behind a slow one.
/// </param>
/// <param name="OpenToRenderMs">
/// Upper end of the interval in which the limit can lie, ms. Set if no pictures were taken between the last one within the range and
/// this value. Null without a limit, or if the gap is smaller than 5 %.
/// </param>
sealed record RangeFitResult(
    double VisuMs, double SpreadMs, double? LimitRenderMs, double ValidToRenderMs, int Pairs, int Used, int Rejected, double? OpenToRenderMs)
{
    public string Json() => JsonText.Of(new { VisuMs, VisuSpreadMs = SpreadMs, LimitRenderMs, ValidToRenderMs, Pairs, Rejected });
}
