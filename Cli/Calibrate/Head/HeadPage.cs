using System.Globalization;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;

namespace Nowpose.Cli.Calibrate.Head;

/// <summary>Creates the page of the latency for head motion, with the distance between both codes over the speed.</summary>
static class HeadPage
{
    /// <summary>Maximum difference between the L_visu of a moving headset and the L_visu of a still one.</summary>
    const double MaxVisuDifferenceMs = 3;

    /// <summary>Maximum uncertainty. Above it, the result does not show whether the display corrects for head motion.</summary>
    const double MaxUncertaintyMs = 5;

    /// <param name="profile">The profile with the latency, or null if no profile is stored.</param>
    /// <param name="conditions">Conditions of the measurement.</param>
    public static CalibrationPageData Of(HeadResult result, LatencyProfile profile, DisplayConditions conditions) => new(
        "Latency for head motion", Sentence(result),
        [
            ["Latency for head motion", $"{Ms(result.LatencyMs)} ± {Ms(result.UncertaintyMs)}"],
            ["L_visu in these pictures", Ms(result.VisuMs)],
            ["Pictures in motion", Count(result.Used.Count)],
            ["Pictures", Count(result.Pictures.Pictures.Count)],
            ["Rejected", Count(result.Pictures.Rejected)],
            ["Speed of the control's code (RMS)", result.SpeedPx.ToString("0", CultureInfo.InvariantCulture) + " px/s"],
            .. profile == null ? [] : ProfileFacts.Of(profile).Select(fact => new[] { "Profile: " + fact[0], fact[1] }),
        ])
    {
        Warnings = [.. WarningsOf(result, profile, conditions)],
        Sections = [OverSpeed(result)],
    };

    static IEnumerable<string> WarningsOf(HeadResult result, LatencyProfile profile, DisplayConditions conditions)
    {
        if (profile == null)
            yield return "no profile was written: add --profile with the profile of the still pictures, to which the latency for head motion is added";
        if (conditions.Reprojection == ReprojectionMode.Unknown)
            yield return "the reprojection mode is unknown: state it with --reprojection, because the latency is valid for one mode only";
        if (result.UncertaintyMs > MaxUncertaintyMs)
            yield return FormattableString.Invariant($"the latency is uncertain by ± {result.UncertaintyMs:0.0} ms: ")
                + "turn farther or faster, or film longer";
        if (profile?.Visualisation.Length.TotalMilliseconds is double still && Math.Abs(still - result.VisuMs) > MaxVisuDifferenceMs)
            yield return FormattableString.Invariant($"L_visu of the moving pictures is {result.VisuMs:0.0} ms, of the still pictures {still:0.0} ms. ")
                + "The profile keeps the latter. Check that both were taken with the same settings and a low load";
    }

    static string Sentence(HeadResult result) => string.Create(CultureInfo.InvariantCulture,
        $"The latency for head motion is {result.LatencyMs:0.0} ms ± {result.UncertaintyMs:0.0} ms (95 %); L_visu is {result.VisuMs:0.0} ms.");

    static CalibrationSection OverSpeed(HeadResult result) => new(
        "Offset of the codes over the speed", null,
        "The slope is the latency for head motion: at a latency L, the picture is behind by the distance that the head moves in L. Without any "
        + "correction, the latency is L_visu minus the prediction time of the head's pose; with a full correction, the line is horizontal.",
        [new("Over the speed", new("speed of the control's code", "px/s"), new("headset's code minus control's code", "px"),
        [
            new(
                "pictures", Looks.Adaptive, [.. result.Used.Select(picture => picture.Speed)],
                [.. result.Used.Select(picture => (double?)picture.Offset)])
            {
                Scattered = true,
            },
        ])]);

    static string Ms(double value) => value.ToString("0.00", CultureInfo.InvariantCulture) + " ms";

    static string Count(int count) => count.ToString(CultureInfo.InvariantCulture);
}
