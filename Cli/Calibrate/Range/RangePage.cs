using Nowpose.Latency;
using Nowpose.Latency.Calibration;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>The sections with the paper's Figs 10 and 11 for a set of pictures.</summary>
static class RangePage
{
    /// <param name="fit">The fit, or null if none was found.</param>
    public static IEnumerable<CalibrationSection> Sections(IReadOnlyList<MeasuredPicture> pictures, RangeFitResult fit)
    {
        var measured = pictures.Where(each => each.RenderMs.HasValue).ToArray();
        if (measured.Length == 0) yield break;
        yield return new("Render time and L_visu from picture to picture", "Fig. 10",
            "While frames are ready in time, L_visu does not depend on the render time; beyond the limit it increases and scatters.",
            [RangePlots.OverPictures("Over pictures", measured)]);
        if (measured.Any(each => each.Vertices.HasValue))
        {
            var (plot, table) = RangePlots.OverLoad(measured);
            yield return new("Render time and L_visu over the load", "Fig. 11a", "Median and middle 68 %. L_visu is constant up to a number of "
                + "vertices that depends on the scene: the render time, which grows with it, is what the headset watches.", [plot], table);
        }
        yield return new("L_visu over the render time", "Fig. 11b", fit?.LimitRenderMs == null
            ? "No limit was reached: L_visu is known to be constant only up to the greatest render time seen."
            : "Left of the limit is the constant-latency range.", [RangePlots.OverRenderTime(measured, fit)]);
    }
}
