namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Creates the page sections with Figs 10 and 11 of the paper for a set of pictures.</summary>
static class RangePage
{
    /// <param name="fit">The fit, or null if there is none.</param>
    public static IEnumerable<CalibrationSection> Sections(IReadOnlyList<MeasuredPicture> pictures, RangeFitResult fit)
    {
        var measured = pictures.Where(each => each.RenderMs.HasValue).ToArray();
        if (measured.Length == 0) yield break;
        yield return new(RangePageTexts.OverPictures, "Fig. 10",
            RangePageTexts.OverPicturesNote,
            [RangePlots.OverPictures("Over pictures", measured)]);
        if (measured.Any(each => each.Vertices.HasValue))
        {
            var (plot, table) = RangePlots.OverLoad(measured);
            yield return new(RangePageTexts.OverLoad, "Fig. 11a", RangePageTexts.OverLoadNote, [plot], table);
        }
        yield return new(RangePageTexts.OverRenderTime, "Fig. 11b", fit?.LimitRenderMs == null
            ? RangePageTexts.NoLimitNote
            : RangePageTexts.LimitNote, [RangePlots.OverRenderTime(measured, fit)]);
    }
}
