using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Creates the page sections with Figs 10 and 11 of the paper for a set of pictures.</summary>
static class RangePage
{
    /// <param name="fit">The fit, or null if there is none.</param>
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
                + "vertices that depends on the scene. The headset monitors the render time, which increases with the load.", [plot], table);
        }
        yield return new("L_visu over the render time", "Fig. 11b", fit?.LimitRenderMs == null
            ? "The limit was not reached: L_visu is constant at least up to the longest measured render time."
            : "Left of the limit is the constant-latency range.", [RangePlots.OverRenderTime(measured, fit)]);
    }
}
