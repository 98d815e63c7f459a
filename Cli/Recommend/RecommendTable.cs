using System.Globalization;
using Nowpose.Session;
using Spectre.Console;

namespace Nowpose.Cli.Recommend;

/// <summary>
/// Prints the recommendation as a table: all candidates with their errors on both halves of the recording, then the recommended settings.
/// </summary>
static class RecommendTable
{
    /// <param name="warnings">Warnings about the reliability of the recommendation.</param>
    public static void Write(
        IAnsiConsole console, string path, RecordingTraits traits, IEnumerable<string> warnings,
        IReadOnlyList<(Recommendation Recommendation, BlendCost Blend)> results)
    {
        var spread = Text($"P5 {1e3 * traits.IntervalP5:0.0}, P95 {1e3 * traits.IntervalP95:0.0}");
        console.WriteLine(RecommendTexts.Recording(Path.GetFileName(path), traits.Duration, 1e3 * traits.Interval, spread, 100 * traits.Repeats));
        foreach (var joints in traits.RoundingSteps.GroupBy(joint => joint.Step))
            console.WriteLine(Text($"rounded to {joints.Key:G4}: ") + string.Join(", ", joints.Select(joint => joint.Name)));
        foreach (var warning in warnings) console.WriteLine("note: " + warning);
        foreach (var (recommendation, blend) in results) Write(console, recommendation, blend);
    }

    static void Write(IAnsiConsole console, Recommendation recommendation, BlendCost blend)
    {
        var table = new Table().Title(Markup.Escape(Condition(recommendation.Subject)));
        table.AddColumn("predictor");
        foreach (var heading in new[] { "RMS", "reduction", "first half", "second half", "against default" })
            table.AddColumn(new TableColumn(heading).RightAligned());
        table.AddColumn("");
        foreach (var trial in recommendation.Trials)
            table.AddRow(
                trial.Predictor, trial.Rms.ToString("G4", CultureInfo.InvariantCulture), Percent(trial.Reduction), Percent(trial.First.Reduction),
                Percent(trial.Second.Reduction), trial == recommendation.Default ? "" : Percent(trial.GainOver(recommendation.Default), "+0.0;-0.0;0.0"),
                Mark(recommendation, trial));
        table.Caption(RecommendTexts.ReductionNote);
        console.Write(table);
        console.WriteLine($"Use predictor {recommendation.Recommended.Predictor}: {recommendation.Reason}.");
        var reduction = Percent(recommendation.Recommended.Reduction, "0");
        console.WriteLine(RecommendTexts.Reduction(reduction, Percent(recommendation.Recommended.First.Reduction, "0"), Percent(recommendation.Recommended.Second.Reduction, "0")));
        // The run was cancelled before the blend was evaluated.
        if (blend.Share == null) return;
        console.WriteLine(RecommendTexts.Blend(
            blend.RecommendedMs.Value, PredictionSettings.DefaultBlendMs, Percent(blend.Share), Percent(blend.ShareOfHalves[0]),
            Percent(blend.ShareOfHalves[1])));
    }

    static string Condition(ISubject subject) => subject.SamplingMs is double sampling
        ? RecommendTexts.Condition(sampling, subject.LatencyMs) : RecommendTexts.AsRecorded;

    static string Mark(Recommendation recommendation, Trial trial) => trial == recommendation.Recommended ? "use this"
        : recommendation.IsTie(trial) ? "tie" : trial == recommendation.Default ? "default" : "";

    static string Percent(double? share, string format = "0.0") =>
        share is double value ? (100 * value).ToString(format, CultureInfo.InvariantCulture) + " %" : "–";

    static string Text(FormattableString text) => FormattableString.Invariant(text);
}
