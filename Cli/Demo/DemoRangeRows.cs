using System.Globalization;
using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Demo;

/// <summary>Formats the constant-latency range for table and report; has no rows without a load.</summary>
sealed class DemoRangeRows(DemoSettings settings, DemoResult result, DemoRange range)
{
    public IEnumerable<(string Label, string Value)> Rows
    {
        get
        {
            if (result.Range is not { } seen) yield break;
            var load = new DemoLoad(settings.Load.Value, settings.Seconds);
            yield return ("render load", FormattableString.Invariant($"{load.Vertices} vertices, from {load.FromSeconds:0.0} to {load.ToSeconds:0.0} s"));
            yield return ("constant-latency range", seen.LimitRenderMs == null ? DemoTexts.NoLimit
                : $"up to {Number(seen.LimitRenderMs, "0.0#")} ms; {AlarmText(seen)}");
            if (seen.FramesOutside > 0) yield return ($"{seen.FramesOutside} frames outside", OutsideText());
        }
    }

    static string AlarmText(DemoResult.Ranges seen)
    {
        if (seen.LeftS == null) return DemoTexts.NeverLeft;
        var found = seen.FoundS == null ? "not found again" : $"found again at {Number(seen.FoundS, "0.0")} s";
        return $"alarm: left at {Number(seen.LeftS, "0.0")} s, {found}" + (seen.Alarms > 1 ? $", {seen.Alarms} alarms" : "");
    }

    string OutsideText() =>
        DemoTexts.Outside(Number(range.VisualisationMs(true), "0.0#"), Number(range.VisualisationMs(false), "0.0#"), Number(range.RmsOutsideMm, "0.00"), Number(range.RmsInTimeMm, "0.00"));

    static string Number(double? value, string format) => value?.ToString(format, CultureInfo.InvariantCulture) ?? "–";
}
