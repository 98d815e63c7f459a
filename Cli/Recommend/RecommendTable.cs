using System.Globalization;
using Nowpose.Session;
using Spectre.Console;

namespace Nowpose.Cli.Recommend;

/// <summary>Prints the recommendation as a table: all candidates with their errors on both halves, then the recommended settings.</summary>
static class RecommendTable
{
    public static void Write(IAnsiConsole console, string path, RecordingTraits traits, IReadOnlyList<(Verdict Verdict, BlendCost Blend)> results)
    {
        var spread = Text($"P5 {1e3 * traits.IntervalP5:0.0}, P95 {1e3 * traits.IntervalP95:0.0}");
        console.WriteLine(Text($"{Path.GetFileName(path)}: {traits.Duration:0.0} s, a sample every {1e3 * traits.Interval:0.0} ms ({spread}), ")
            + Text($"{100 * traits.Repeats:0.0} % repeated"));
        foreach (var joints in traits.RoundingSteps.GroupBy(joint => joint.Step))
            console.WriteLine(Text($"rounded to {joints.Key:G4}: ") + string.Join(", ", joints.Select(joint => joint.Name)));
        foreach (var warning in traits.Warnings()) console.WriteLine("note: " + warning);
        foreach (var (verdict, blend) in results) Write(console, verdict, blend);
    }

    static void Write(IAnsiConsole console, Verdict verdict, BlendCost blend)
    {
        var table = new Table().Title(Markup.Escape(Condition(verdict.Subject)));
        table.AddColumn("predictor");
        foreach (var heading in new[] { "RMS", "reduction", "first half", "second half", "against default" })
            table.AddColumn(new TableColumn(heading).RightAligned());
        table.AddColumn("");
        foreach (var trial in verdict.Trials)
            table.AddRow(
                trial.Predictor, trial.Rms.ToString("G4", CultureInfo.InvariantCulture), Percent(trial.Reduction), Percent(trial.First.Reduction),
                Percent(trial.Second.Reduction), trial == verdict.Default ? "" : Percent(trial.GainOver(verdict.Default), "+0.0;-0.0;0.0"),
                Mark(verdict, trial));
        table.Caption("reduction: share of the error of showing the newest sample that the predictor removes");
        console.Write(table);
        console.WriteLine($"Use predictor {verdict.Recommended.Predictor}: {verdict.Reason}.");
        var reduction = Percent(verdict.Recommended.Reduction, "0");
        console.WriteLine($"It removes {reduction} of the error ({Percent(verdict.Recommended.First.Reduction, "0")} and "
            + $"{Percent(verdict.Recommended.Second.Reduction, "0")} in the halves).");
        // The run was cancelled before the blend was evaluated.
        if (blend.Share == null) return;
        console.WriteLine(Text($"Use blend {blend.RecommendedMs:0} ms: ")
            + $"{PredictionSettings.DefaultBlendMs} ms cost {Percent(blend.Share)} of RMS error ({Percent(blend.ShareOfHalves[0])} and "
            + $"{Percent(blend.ShareOfHalves[1])} in the halves), and remove the jumps between predictions.");
    }

    static string Condition(ISubject subject) => subject.SamplingMs is double sampling
        ? Text($"a sample every {sampling:0.###} ms, {subject.LatencyMs:0.###} ms late") : "samples, latencies and frames as recorded";

    static string Mark(Verdict verdict, Trial trial) => trial == verdict.Recommended ? "use this"
        : verdict.IsTie(trial) ? "tie" : trial == verdict.Default ? "default" : "";

    static string Percent(double? share, string format = "0.0") =>
        share is double value ? (100 * value).ToString(format, CultureInfo.InvariantCulture) + " %" : "–";

    static string Text(FormattableString text) => FormattableString.Invariant(text);
}
