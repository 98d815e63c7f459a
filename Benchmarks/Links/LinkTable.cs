using System.Globalization;
using System.Text.Json;
using Nowpose.Cli;
using Spectre.Console;

namespace Nowpose.Benchmarks.Links;

/// <summary>Writes the medians over the repeats as a table, and formats the results of all runs as JSON.</summary>
static class LinkTable
{
    const int Width = 170;

    static readonly JsonSerializerOptions Snake = new() { PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower, WriteIndented = true };

    public static void Write(IReadOnlyList<LinkResult> results)
    {
        var console = ResultConsole.Create();
        if (Console.IsOutputRedirected) console.Profile.Width = Width;
        var table = new Table().AddColumns(
            "link", "runs", "current\nafter s", "coarse\ns", "synchro-\nnised s", "current\n%", "not cur-\nrent s",
            "reduc-\ntion %", "error mm\n(uncom-\npensated)", "clock error\nP50, P99 µs", "stated\n± µs", "within\n± %",
            "stall: held\nafter s, back s", "late: packets\nµs, frames ms");
        foreach (var runs in results.GroupBy(result => result.Profile)) table.AddRow([.. Row([.. runs]).Select(Markup.Escape)]);
        console.Write(table);
        console.WriteLine(
            "Medians over the runs. Errors are relative to the true motion and the true clock. "
            + "Stall: times until the pose is held and until it is current again. "
            + "Late: P99 of the delays that other load on this machine causes.");
    }

    public static string Json(IReadOnlyList<LinkResult> results) => JsonSerializer.Serialize(results, Snake);

    static IEnumerable<string> Row(IReadOnlyList<LinkResult> runs)
    {
        string Median(Func<LinkResult, double?> value, string format, double scale = 1) =>
            LinkLimits.Median(runs, value) is double median ? (scale * median).ToString(format, CultureInfo.InvariantCulture) : "–";
        yield return runs[0].Profile;
        yield return runs.Count.ToString(CultureInfo.InvariantCulture);
        yield return Median(run => run.CurrentAfterS, "0.00");
        yield return Median(run => run.CoarseAfterS, "0.00");
        yield return Median(run => run.SynchronisedAfterS, "0.00");
        yield return Median(run => run.CurrentShare, "0.0", 100);
        yield return Median(run => run.LongestNotCurrentS, "0.00");
        yield return Median(run => run.Reduction, "0.0", 100);
        yield return $"{Median(run => run.RmsMm, "0.00")} ({Median(run => run.HoldRmsMm, "0.0")})";
        yield return $"{Median(run => run.ClockErrorUsP50, "0")}, {Median(run => run.ClockErrorUsP99, "0")}";
        yield return Median(run => run.StatedErrorUsP50, "0");
        yield return Median(run => run.WithinStatedShare, "0.0", 100);
        yield return $"{Median(run => run.HeldAfterS, "0.00")}, {Median(run => run.RecoveredAfterS, "0.00")}";
        yield return $"{Median(run => run.ReleaseLateUsP99, "0")}, {Median(run => run.FrameLateMsP99, "0.0")}";
    }
}
