using System.Globalization;
using Spectre.Console;

namespace Nowpose.Cli.Headset;

/// <summary>The result for reading.</summary>
static class HeadsetTable
{
    public static void Print(HeadsetResult result)
    {
        var console = ResultConsole.Create();
        console.WriteLine($"{result.Robot}: how a headset does on this gateway");
        var grid = new Grid().AddColumn().AddColumn();
        void Row(string label, string value) => grid.AddRow(Markup.Escape(label), Markup.Escape(value));
        var clock = result.Clock;
        Row("clock", $"{clock.State}, ± {Text(clock.ErrorBoundUs, "0", " µs")}, {Text(clock.SkewPpm, "+0.0;-0.0", " ppm")}, "
            + $"round trip {Text(clock.RttMs, "0.00", " ms")}");
        Row("synchronised after", Text(clock.SynchronisedAfterS, "0.0", " s"));
        Row("clock steps", clock.Steps.ToString(CultureInfo.InvariantCulture));
        var latency = result.LatencyMs;
        Row("application latency", $"{Text(latency.AppP50, "0.0", " ms")} median, {Text(latency.AppP95, "0.0", " ms")} P95");
        Row("visualisation latency, as told", Text(latency.Visu, "0.0", " ms"));
        Row("end-to-end latency", Text(latency.EndToEnd, "0.0", " ms"));
        var pose = result.Pose;
        Row("pose", $"{pose.State}; current after {Text(pose.CurrentAfterS, "0.0", " s")}, "
            + $"then for {Text(100 * pose.CurrentShare, "0.0", " %")} of the frames");
        Row("longest time not current", Text(pose.LongestNotCurrentS, "0.00", " s"));
        var error = result.ToolErrorMm;
        Row("tool, uncompensated", $"{Text(error?.HoldRms, "0.00", " mm")} RMS, {Text(error?.HoldP95, "0.00", " mm")} P95");
        Row("tool, compensated", $"{Text(error?.Rms, "0.00", " mm")} RMS, {Text(error?.P95, "0.00", " mm")} P95");
        Row("reduction, as the headset measured it", $"{Text(100 * error?.Reduction, "0.0", " %")} ± "
            + $"{Text(100 * error?.ReductionUncertainty, "0.0", " %")}");
        Row("frames, samples, dropped", $"{result.Frames}, {result.Samples}, {result.Dropped}");
        console.Write(grid);
    }

    static string Text(double? value, string format, string unit) =>
        value is double number ? number.ToString(format, CultureInfo.InvariantCulture) + unit : "–";
}
