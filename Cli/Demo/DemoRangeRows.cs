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
            yield return (DemoTexts.RenderLoadRow, DemoTexts.RenderLoad(load.Vertices, load.FromSeconds, load.ToSeconds));
            yield return (DemoTexts.RangeRow, seen.LimitRenderMs == null ? DemoTexts.NoLimit
                : DemoTexts.Range(RunTexts.Number(seen.LimitRenderMs, "0.0#"), AlarmText(seen)));
            if (seen.FramesOutside > 0) yield return (DemoTexts.FramesOutside(seen.FramesOutside), OutsideText());
        }
    }

    static string AlarmText(DemoResult.Ranges seen)
    {
        if (seen.LeftS == null) return DemoTexts.NeverLeft;
        var found = seen.FoundS == null ? DemoTexts.NotFoundAgain : DemoTexts.FoundAgain(RunTexts.Number(seen.FoundS, "0.0"));
        return DemoTexts.Alarm(RunTexts.Number(seen.LeftS, "0.0"), found, seen.Alarms);
    }

    string OutsideText() => DemoTexts.Outside(
        RunTexts.Number(range.VisualisationMs(true), "0.0#"), RunTexts.Number(range.VisualisationMs(false), "0.0#"),
        RunTexts.Number(range.RmsOutsideMm, "0.00"), RunTexts.Number(range.RmsInTimeMm, "0.00"));
}
