using System.CommandLine;
using System.Globalization;
using Nowpose.Gateway.Options;
using Nowpose.Simulation;
using Nowpose.Sync;

namespace Nowpose.Benchmarks.Paths;

/// <summary>paths: what the clock does when the least delays of a path change, as when a headset roams.</summary>
static class PathsVerb
{
    static readonly double[] SizesMs = [0.5, 2, 4, 20];

    public static Task<int> RunAsync(string[] args)
    {
        var seeds = NumberOption.Create("--seeds", "Runs of each change", 6, 1, 1000, "");
        var first = NumberOption.Create("--first-seed", "Of the first run; each further one takes the next", 7000, 0, 1_000_000, "");
        var estimator = new Option<string>("--estimator")
        {
            Description = $"Clock estimator [{string.Join(", ", ClockEstimators.Names)}]", HelpName = "NAME",
            DefaultValueFactory = _ => ClockEstimators.Default,
        };
        estimator.AcceptOnlyFromAmong([.. ClockEstimators.Names]);
        var command = new Command("paths", "The clock while the least delays of a path change, in virtual time, against the true clock")
        {
            seeds, first, estimator,
        };
        command.SetAction((parsed, stop) =>
        {
            Write(parsed.GetValue(estimator), parsed.GetValue(first), parsed.GetValue(seeds), stop);
            return Task.FromResult(ExitStatus.Done);
        });
        return Invocation.RunAsync(Invocation.Root("nowpose-benchmarks", "What Nowpose costs.", command), args);
    }

    static void Write(string estimator, int first, int seeds, CancellationToken stop)
    {
        Console.WriteLine($"| link | change | {string.Join(" | ", SizesMs.Select(size => Text($"{size} ms")))} |");
        Console.WriteLine($"| --- | --- | {string.Join(" | ", SizesMs.Select(_ => "---"))} |");
        // A stall hides every change of the delays for seconds.
        foreach (var link in LinkProfile.All.Where(link => link.StallInterval == TimeSpan.Zero))
            foreach (var change in PathChange.All)
            {
                stop.ThrowIfCancellationRequested();
                var cells = SizesMs.Select(size => Cell(
                    [.. Enumerable.Range(first, seeds).AsParallel().Select(seed => PathRun.Play(link, change, size, estimator, seed))], change.Limit * size));
                Console.WriteLine($"| {link.Name} | {change.Name} | {string.Join(" | ", cells)} |");
            }

        Console.WriteLine();
        Console.WriteLine(
            "Greatest error / half the difference of the changes of both directions, greatest distance of the skew from its value before, and "
            + "the share of the time in which the error was within the stated ±; from 5 s after the change on.");
    }

    static string Cell(PathRun[] runs, double limitMs) => Text(
        $"{runs.Max(run => run.ErrorMs):0.00} / {limitMs:0.##} ms, {runs.Max(run => run.SkewPpm):0.0} ppm, {100 * runs.Average(run => run.Within):0} %");

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
