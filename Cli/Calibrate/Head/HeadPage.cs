using System.Globalization;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;

namespace Nowpose.Cli.Calibrate.Head;

/// <summary>Creates the page that reports the latency for head motion. It shows the distance between both codes as a function of the speed.</summary>
static class HeadPage
{
    /// <summary>Maximum difference between the L_visu of a moving headset and the L_visu of a still one.</summary>
    const double MaxVisuDifferenceMs = 3;

    /// <summary>Maximum uncertainty. Above it, the result does not show whether the display corrects for head motion.</summary>
    const double MaxUncertaintyMs = 5;

    /// <param name="profile">The profile with the latency, or null if no profile is stored.</param>
    /// <param name="conditions">Conditions of the measurement.</param>
    public static CalibrationPageData Of(HeadResult result, LatencyProfile profile, DisplayConditions conditions) => new(
        CalibrationPageTexts.HeadMotion, Sentence(result),
        [
            [CalibrationPageTexts.HeadMotion, $"{Ms(result.LatencyMs)} ± {Ms(result.UncertaintyMs)}"],
            ["L_visu in these pictures", Ms(result.VisuMs)],
            ["Pictures in motion", Count(result.Used.Count)],
            ["Pictures", Count(result.Pictures.Pictures.Count)],
            ["Rejected", Count(result.Pictures.Rejected)],
            [CalibrationPageTexts.ControlCodeSpeed, result.SpeedPx.ToString("0", CultureInfo.InvariantCulture) + " px/s"],
            .. profile == null ? [] : ProfileFacts.Of(profile).Select(fact => new[] { "Profile: " + fact[0], fact[1] }),
        ])
    {
        Warnings = [.. WarningsOf(result, profile, conditions)],
        Sections = [OverSpeed(result)],
    };

    static IEnumerable<string> WarningsOf(HeadResult result, LatencyProfile profile, DisplayConditions conditions)
    {
        if (profile == null)
            yield return HeadMotionMessages.NoProfile;
        if (conditions.Reprojection == ReprojectionMode.Unknown)
            yield return HeadMotionMessages.UnknownReprojection;
        if (result.Span.IsNarrow)
            yield return VlcMessages.NarrowExposures(result.Span.Ms, result.Span.MaxErrorMs);
        if (result.UncertaintyMs > MaxUncertaintyMs)
            yield return HeadMotionMessages.Uncertain(result.UncertaintyMs);
        if (profile?.Visualisation.Length.TotalMilliseconds is double still && Math.Abs(still - result.VisuMs) > MaxVisuDifferenceMs)
            yield return HeadMotionMessages.OtherVisu(result.VisuMs, still);
    }

    static string Sentence(HeadResult result) => CalibrationPageTexts.HeadMotionResult(result.LatencyMs, result.UncertaintyMs, result.VisuMs);

    static CalibrationSection OverSpeed(HeadResult result) => new(CalibrationPageTexts.OffsetOverSpeed, null,
        CalibrationPageTexts.OffsetOverSpeedNote,
        [new("Over the speed", new(CalibrationPageTexts.ControlCodeSpeedAxis, "px/s"), new(CalibrationPageTexts.CodeOffsetAxis, "px"),
            [PlotTrace.Points("pictures", Looks.Adaptive, result.Used.Select(picture => (picture.Speed, picture.Offset)))])]);

    static string Ms(double value) => value.ToString("0.00", CultureInfo.InvariantCulture) + " ms";

    static string Count(int count) => count.ToString(CultureInfo.InvariantCulture);
}
