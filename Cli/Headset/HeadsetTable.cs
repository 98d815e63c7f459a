using System.Globalization;
using Nowpose.Cli.Messages;
using Nowpose.Messages;
using Spectre.Console;

namespace Nowpose.Cli.Headset;

/// <summary>Prints the result as a table.</summary>
static class HeadsetTable
{
    /// <summary>Maximum length of a label or a value in characters.</summary>
    const int MaxLength = 2000;

    public static void Print(HeadsetResult result, IAnsiConsole console)
    {
        console.WriteLine(HeadsetTexts.Title(result.Robot));
        var grid = new Grid().AddColumn().AddColumn();
        // Names from the network may contain characters that control a terminal.
        void Row(string label, string value) => grid.AddRow(Shown(label), Shown(value));
        if (result.VersionMismatch != null) Row(HeadsetTexts.Versions, result.VersionMismatch);
        var clock = result.Clock;
        Row(HeadsetTexts.ClockRow, HeadsetTexts.Clock(
            clock.State, Text(clock.EstimatedErrorUs, "0", " µs"), Text(clock.ErrorBoundUs, "0", " µs"), Text(clock.SkewPpm, "+0.0;-0.0;0.0", " ppm"),
            Text(clock.RttMs, "0.00", " ms")));
        Row(HeadsetTexts.CoarseAfter, Text(clock.CoarseAfterS, "0.0", " s"));
        Row(HeadsetTexts.SynchronisedAfter, Text(clock.SynchronisedAfterS, "0.0", " s"));
        Row(HeadsetTexts.ClockSteps, clock.Steps.ToString(CultureInfo.InvariantCulture));
        var latency = result.LatencyMs;
        Row(RunTexts.ApplicationLatency, RunTexts.MedianP95(Text(latency.AppP50, "0.0", " ms"), Text(latency.AppP95, "0.0", " ms")));
        Row(HeadsetTexts.VisualisationLatency, Text(latency.Visu, "0.0", " ms"));
        Row(HeadsetTexts.EndToEndLatency, Text(latency.EndToEnd, "0.0", " ms"));
        var pose = result.Pose;
        Row(HeadsetTexts.PoseRow, HeadsetTexts.Pose(pose.State, Text(pose.CurrentAfterS, "0.0", " s"), Text(100 * pose.CurrentShare, "0.0", " %")));
        Row(HeadsetTexts.OutageDuration, Text(pose.LongestNotCurrentS, "0.00", " s"));
        if (result.MissingJoints.Count > 0) Row(HeadsetTexts.MissingJoints, string.Join(", ", result.MissingJoints));
        foreach (var joint in result.Joints) Row(HeadsetTexts.Joint(joint.Name), StateOf(joint.State, joint.SinceS, joint.Reason));
        foreach (var part in result.ObjectsNotCurrent) Row(HeadsetTexts.Object(part.Name), NotCurrent(part));
        foreach (var part in result.ObjectsNotFollowed) Row(HeadsetTexts.Object(part.Name), HeadsetTexts.NotFollowed(part.Link));
        foreach (var part in result.SignalsNotCurrent) Row(HeadsetTexts.Signal(part.Name), NotCurrent(part));
        foreach (var outage in result.Outages)
            Row(
                HeadsetTexts.Outage(Text(outage.FromS, "0.0", ""), Text(outage.ToS ?? result.Seconds, "0.0", " s")),
                outage.Pose + (outage.Reason.Length == 0 ? "" : ": " + outage.Reason));
        if (result.OutagesNotListed > 0) Row(HeadsetTexts.MoreOutages, HeadsetTexts.NotListed(result.OutagesNotListed));
        AddErrors(Row, "", result.ToolErrorMm);
        if (pose.NotCurrentS > 0) Row(HeadsetTexts.NotScored, HeadsetTexts.NotCurrent(Text(pose.NotCurrentS, "0.00", " s")));
        // A single stretch is the complete run, which is already shown.
        for (var i = 0; i < result.Stretches.Count && result.Stretches.Count > 1; i++) AddStretch(Row, i + 1, result.Stretches[i]);
        Row(RunTexts.CountsRow, RunTexts.Counts(result.Frames, result.Samples, result.Dropped));
        console.Write(grid);
    }

    static string Shown(string text) => Markup.Escape(InputException.OneLine(text, MaxLength));

    static string NotCurrent(HeadsetResult.PartResult part) => StateOf(StateNames.NotCurrent, part.SinceS, part.Reason);

    static string StateOf(string state, double? sinceS, string reason) =>
        StateNames.Describe(state, sinceS == null ? "" : HeadsetTexts.Duration(Text(sinceS, "0", " s")), reason);

    static void AddStretch(Action<string, string> row, int number, HeadsetResult.StretchResult stretch)
    {
        var prefix = HeadsetTexts.Stretch(number);
        row(prefix + HeadsetTexts.PoseRow, HeadsetTexts.CurrentShare(
            Text(100 * stretch.CurrentShare, "0.0", " %"), Text(stretch.FromS, "0.0", ""), Text(stretch.ToS, "0.0", " s")));
        AddErrors(row, prefix, stretch.ToolErrorMm);
    }

    static void AddErrors(Action<string, string> row, string prefix, HeadsetResult.ErrorResult error)
    {
        row(HeadsetTexts.Uncompensated(prefix), HeadsetTexts.RmsP95(Text(error?.HoldRms, "0.00", " mm"), Text(error?.HoldP95, "0.00", " mm")));
        row(HeadsetTexts.Compensated(prefix), HeadsetTexts.RmsP95(Text(error?.Rms, "0.00", " mm"), Text(error?.P95, "0.00", " mm")));
        row(HeadsetTexts.Reduction(prefix), $"{Text(100 * error?.Reduction, "0.0", " %")} ± "
            + $"{Text(100 * error?.ReductionUncertainty, "0.0", " %")}");
    }

    static string Text(double? value, string format, string unit) =>
        value is double number ? number.ToString(format, CultureInfo.InvariantCulture) + unit : "–";
}
