using System.Globalization;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Creates a profile and a page from pictures at several loads.</summary>
static class RangeProfile
{
    public static LatencyProfile Of(
        RangeFitResult fit, DisplayConditions conditions, RenderTimeSourceKind source, HeadMotionLatency head = null) => new(
        fit.VisuMs, fit.SpreadMs, conditions, DateTime.UtcNow, CalibrationMethod.VisibleLight, fit.Used,
        fit.LimitRenderMs, source, fit.ValidToRenderMs, head);

    /// <param name="more">Additional facts about the measuring method.</param>
    /// <param name="warnings">Additional warnings; null if there are none.</param>
    public static CalibrationPageData Page(
        string title, LatencyProfile profile, RangeFitResult fit, IReadOnlyList<MeasuredPicture> pictures, IEnumerable<string[]> more,
        IEnumerable<string> warnings = null) =>
        new(title, Sentence(fit), [.. ProfileFacts.Of(profile), ["Pairs", Count(fit.Pairs)], [RangePageTexts.OutsidePlateau, Count(fit.Rejected)], .. more])
        {
            Warnings = [.. warnings ?? [], .. WarningsOf(fit)],
            Sections = [.. RangePage.Sections(pictures, fit)],
        };

    static string Sentence(RangeFitResult fit) => fit.LimitRenderMs is double limit
        ? RangePageTexts.Result(fit.VisuMs, fit.SpreadMs, limit)
        : RangePageTexts.ResultWithoutLimit(fit.VisuMs, fit.SpreadMs, fit.ValidToRenderMs);

    static IEnumerable<string> WarningsOf(RangeFitResult fit)
    {
        if (fit.LimitRenderMs == null)
            yield return RangeMessages.NoLimit;
        if (fit.OpenToRenderMs is double open)
            yield return RangeMessages.LimitBetween(fit.LimitRenderMs, open);
    }

    static string Count(int count) => count.ToString(CultureInfo.InvariantCulture);
}
