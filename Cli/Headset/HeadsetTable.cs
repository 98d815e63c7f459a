using System.Globalization;
using Nowpose.Cli.Messages;
using Spectre.Console;

namespace Nowpose.Cli.Headset;

/// <summary>Prints the result as a table.</summary>
static class HeadsetTable
{
    public static void Print(HeadsetResult result, IAnsiConsole console)
    {
        console.WriteLine(HeadsetTexts.Title(result.Robot));
        var grid = new Grid().AddColumn().AddColumn();
        void Row(string label, string value) => grid.AddRow(Markup.Escape(label), Markup.Escape(value));
        if (result.VersionMismatch != null) Row("versions", result.VersionMismatch);
        var clock = result.Clock;
        Row("clock", $"{clock.State}, ± {Text(clock.EstimatedErrorUs, "0", " µs")} (proven ± {Text(clock.ErrorBoundUs, "0", " µs")}), {Text(clock.SkewPpm, "+0.0;-0.0;0.0", " ppm")}, "
            + $"round trip {Text(clock.RttMs, "0.00", " ms")}");
        Row("coarse after", Text(clock.CoarseAfterS, "0.0", " s"));
        Row("synchronised after", Text(clock.SynchronisedAfterS, "0.0", " s"));
        Row("clock steps", clock.Steps.ToString(CultureInfo.InvariantCulture));
        var latency = result.LatencyMs;
        Row("application latency", $"{Text(latency.AppP50, "0.0", " ms")} median, {Text(latency.AppP95, "0.0", " ms")} P95");
        Row("visualisation latency, configured", Text(latency.Visu, "0.0", " ms"));
        Row("end-to-end latency", Text(latency.EndToEnd, "0.0", " ms"));
        var pose = result.Pose;
        Row("pose", HeadsetTexts.Pose(pose.State, Text(pose.CurrentAfterS, "0.0", " s"), Text(100 * pose.CurrentShare, "0.0", " %")));
        Row(HeadsetTexts.OutageDuration, Text(pose.LongestNotCurrentS, "0.00", " s"));
        if (result.MissingJoints.Count > 0) Row("joints without data", string.Join(", ", result.MissingJoints));
        foreach (var joint in result.Joints) Row("joint " + joint.Name, JointOf(joint));
        foreach (var outage in result.Outages)
            Row($"outage from {Text(outage.FromS, "0.0", "")} to {Text(outage.ToS ?? result.Seconds, "0.0", " s")}", outage.Pose + (outage.Reason.Length == 0 ? "" : ": " + outage.Reason));
        AddErrors(Row, "", result.ToolErrorMm);
        if (pose.NotCurrentS > 0) Row("tool, not scored", HeadsetTexts.NotCurrent(Text(pose.NotCurrentS, "0.00", " s")));
        // A single stretch is the complete run, which is already shown.
        for (var i = 0; i < result.Stretches.Count && result.Stretches.Count > 1; i++) AddStretch(Row, i + 1, result.Stretches[i]);
        Row("frames, samples, dropped", $"{result.Frames}, {result.Samples}, {result.Dropped}");
        console.Write(grid);
    }

    static string JointOf(HeadsetResult.JointResult joint) =>
        joint.State + (joint.SinceS == null ? "" : " for " + Text(joint.SinceS, "0", " s")) + (joint.Reason.Length == 0 ? "" : ": " + joint.Reason);

    static void AddStretch(Action<string, string> row, int number, HeadsetResult.StretchResult stretch)
    {
        var prefix = $"stretch {number}: ";
        row(prefix + "pose", HeadsetTexts.CurrentShare(Text(100 * stretch.CurrentShare, "0.0", " %"), Text(stretch.FromS, "0.0", ""), Text(stretch.ToS, "0.0", " s")));
        AddErrors(row, prefix, stretch.ToolErrorMm);
    }

    static void AddErrors(Action<string, string> row, string prefix, HeadsetResult.ErrorResult error)
    {
        row(prefix + "tool, uncompensated", $"{Text(error?.HoldRms, "0.00", " mm")} RMS, {Text(error?.HoldP95, "0.00", " mm")} P95");
        row(prefix + "tool, compensated", $"{Text(error?.Rms, "0.00", " mm")} RMS, {Text(error?.P95, "0.00", " mm")} P95");
        row(HeadsetTexts.Reduction(prefix), $"{Text(100 * error?.Reduction, "0.0", " %")} ± "
            + $"{Text(100 * error?.ReductionUncertainty, "0.0", " %")}");
    }

    static string Text(double? value, string format, string unit) =>
        value is double number ? number.ToString(format, CultureInfo.InvariantCulture) + unit : "–";
}
