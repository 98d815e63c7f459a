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
    /// <param name="warnings">Additional warnings, or null for none.</param>
    public static CalibrationPageData Page(
        string title, LatencyProfile profile, RangeFitResult fit, IReadOnlyList<MeasuredPicture> pictures, IEnumerable<string[]> more,
        IEnumerable<string> warnings = null) =>
        new(title, Sentence(fit), [.. ProfileFacts.Of(profile), ["Pairs", Count(fit.Pairs)], ["Outside the plateau (misread, or behind a slow frame)", Count(fit.Rejected)], .. more])
        {
            Warnings = [.. warnings ?? [], .. WarningsOf(fit)],
            Sections = [.. RangePage.Sections(pictures, fit)],
        };

    static string Sentence(RangeFitResult fit) => fit.LimitRenderMs is double limit
        ? string.Create(CultureInfo.InvariantCulture, $"L_visu is {fit.VisuMs:0.0} ms ± {fit.SpreadMs:0.0} ms while the render time is below {limit:0.00} ms.")
        : string.Create(CultureInfo.InvariantCulture,
            $"L_visu is {fit.VisuMs:0.0} ms ± {fit.SpreadMs:0.0} ms; limit not reached: constant at least up to a render time of {fit.ValidToRenderMs:0.00} ms.");

    static IEnumerable<string> WarningsOf(RangeFitResult fit)
    {
        if (fit.LimitRenderMs == null)
            yield return "limit not reached: beyond the longest measured render time the headset reports the range as unknown; "
                + "extend the sweep to a higher load";
        if (fit.OpenToRenderMs is double open)
            yield return FormattableString.Invariant(
                $"the limit is between {fit.LimitRenderMs:0.00} ms, which is used, and {open:0.00} ms: sweep in finer steps around it");
    }

    static string Count(int count) => count.ToString(CultureInfo.InvariantCulture);
}
