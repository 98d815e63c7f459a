using System.Globalization;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;

namespace Nowpose.Cli.Calibrate;

/// <summary>Formats a profile as text for the table and the page.</summary>
static class ProfileFacts
{
    public static IEnumerable<string[]> Of(LatencyProfile profile)
    {
        yield return ["L_visu", Ms(profile.Visualisation.Length)];
        yield return ["Spread (standard deviation)", Ms(profile.Spread)];
        yield return ["Render time limit", profile.Range == null ? "unknown" : Ms(profile.Range.Limit)];
        if (profile.ValidToRenderTime is TimeSpan valid) yield return [CalibrationPageTexts.ConstantUpTo, Ms(valid)];
        if (profile.Range != null) yield return [CalibrationPageTexts.RenderTimeSource, LatencyNames.RenderTimeSource.NameOf(profile.Range.Source)];
        yield return ["Device", profile.Device.Length > 0 ? profile.Device : CalibrationPageTexts.ValidForAny];
        yield return ["Display", profile.DisplayHz > 0 ? profile.DisplayHz.ToString("0.##", CultureInfo.InvariantCulture) + " Hz" : CalibrationPageTexts.ValidForAny];
        for (var condition = DisplayCondition.GraphicsApi; condition <= DisplayCondition.Reprojection; condition++)
            if (profile.Conditions[condition] is string value) yield return [DisplayConditionNames.TitleOf(condition), value];
        if (profile.HeadMotion is HeadMotionLatency head) yield return [CalibrationPageTexts.HeadMotion, $"{Ms(head.Latency)} ± {Ms(head.Uncertainty)}"];
        yield return ["Measurements", profile.Measurements.ToString(CultureInfo.InvariantCulture)];
    }

    static string Ms(TimeSpan length) => length.TotalMilliseconds.ToString("0.00", CultureInfo.InvariantCulture) + " ms";
}
