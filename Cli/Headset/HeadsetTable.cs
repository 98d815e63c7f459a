using System.Globalization;
using Nowpose.Messages;
using Spectre.Console;
using static Nowpose.Cli.Messages.RunTexts;

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
            clock.State, Number(clock.EstimatedErrorUs, "0", " µs"), Number(clock.ErrorBoundUs, "0", " µs"), Number(clock.SkewPpm, "+0.0;-0.0;0.0", " ppm"),
            Number(clock.RttMs, "0.00", " ms")));
        Row(HeadsetTexts.CoarseAfter, Number(clock.CoarseAfterS, "0.0", " s"));
        Row(HeadsetTexts.SynchronisedAfter, Number(clock.SynchronisedAfterS, "0.0", " s"));
        Row(HeadsetTexts.ClockSteps, clock.Steps.ToString(CultureInfo.InvariantCulture));
        var latency = result.LatencyMs;
        Row(HeadsetTexts.ApplicationLatency, HeadsetTexts.MedianP95(Number(latency.AppP50, "0.0", " ms"), Number(latency.AppP95, "0.0", " ms")));
        Row(HeadsetTexts.VisualisationLatency, Number(latency.Visu, "0.0", " ms"));
        Row(HeadsetTexts.EndToEndLatency, Number(latency.EndToEnd, "0.0", " ms"));
        var pose = result.Pose;
        Row(HeadsetTexts.PoseRow, HeadsetTexts.Pose(pose.State, Number(pose.CurrentAfterS, "0.0", " s"), Number(100 * pose.CurrentShare, "0.0", " %")));
        Row(HeadsetTexts.OutageDuration, Number(pose.LongestNotCurrentS, "0.00", " s"));
        if (result.MissingJoints.Count > 0) Row(HeadsetTexts.MissingJoints, string.Join(", ", result.MissingJoints));
        foreach (var joint in result.Joints) Row(HeadsetTexts.Joint(joint.Name), StateOf(joint.State, joint.SinceS, joint.Reason));
        foreach (var part in result.ObjectsNotCurrent) Row(HeadsetTexts.Object(part.Name), NotCurrent(part));
        foreach (var part in result.ObjectsNotFollowed) Row(HeadsetTexts.Object(part.Name), HeadsetTexts.NotFollowed(part.Link));
        foreach (var part in result.SignalsNotCurrent) Row(HeadsetTexts.Signal(part.Name), NotCurrent(part));
        foreach (var outage in result.Outages)
            Row(
                HeadsetTexts.Outage(Number(outage.FromS, "0.0", ""), Number(outage.ToS ?? result.Seconds, "0.0", " s")),
                outage.Pose + (outage.Reason.Length == 0 ? "" : ": " + outage.Reason));
        if (result.OutagesNotListed > 0) Row(HeadsetTexts.MoreOutages, HeadsetTexts.NotListed(result.OutagesNotListed));
        AddErrors(Row, "", result.ToolErrorMm);
        if (pose.NotCurrentS > 0) Row(HeadsetTexts.NotScored, HeadsetTexts.NotCurrent(Number(pose.NotCurrentS, "0.00", " s")));
        // A single stretch is the complete run, which is already shown.
        for (var i = 0; i < result.Stretches.Count && result.Stretches.Count > 1; i++) AddStretch(Row, i + 1, result.Stretches[i]);
        Row(HeadsetTexts.CountsRow, Counts(result.Frames, result.Samples, result.Dropped));
        console.Write(grid);
    }

    static string Shown(string text) => Markup.Escape(InputException.OneLine(text, MaxLength));

    static string NotCurrent(HeadsetResult.PartResult part) => StateOf(StateNames.NotCurrent, part.SinceS, part.Reason);

    static string StateOf(string state, double? sinceS, string reason) =>
        StateNames.Describe(state, sinceS == null ? "" : HeadsetTexts.Duration(Number(sinceS, "0", " s")), reason);

    static void AddStretch(Action<string, string> row, int number, HeadsetResult.StretchResult stretch)
    {
        var prefix = HeadsetTexts.Stretch(number);
        row(prefix + HeadsetTexts.PoseRow, HeadsetTexts.CurrentShare(
            Number(100 * stretch.CurrentShare, "0.0", " %"), Number(stretch.FromS, "0.0", ""), Number(stretch.ToS, "0.0", " s")));
        AddErrors(row, prefix, stretch.ToolErrorMm);
    }

    static void AddErrors(Action<string, string> row, string prefix, HeadsetResult.ErrorResult error)
    {
        row(HeadsetTexts.Uncompensated(prefix), HeadsetTexts.RmsP95(Number(error?.HoldRms, "0.00", " mm"), Number(error?.HoldP95, "0.00", " mm")));
        row(HeadsetTexts.Compensated(prefix), HeadsetTexts.RmsP95(Number(error?.Rms, "0.00", " mm"), Number(error?.P95, "0.00", " mm")));
        row(HeadsetTexts.Reduction(prefix), $"{Number(100 * error?.Reduction, "0.0", " %")} ± "
            + $"{Number(100 * error?.ReductionUncertainty, "0.0", " %")}");
    }
}
