using System.CommandLine;
using System.Globalization;
using Nowpose.Benchmarks.Links;
using Nowpose.Cli;
using Nowpose.Gateway.Options;

namespace Nowpose.Benchmarks.Paths;

/// <summary>paths: measures the clock when the minimum delays of a path change, for example when a headset changes its access point.</summary>
static class PathsVerb
{
    static readonly double[] SizesMs = [0.5, 2, 4, 20];

    public static Command Create()
    {
        var seeds = NumberOption.Create("--seeds", "Number of runs for each change", 6, 1, 1000, "");
        var first = NumberOption.Create("--first-seed", "Seed of the first run; each further run uses the next one", 7000, 0, 1_000_000, "");
        var size = NumberOption.CreateOptional("--size-ms", $"Size of the changes; {string.Join(", ", SizesMs.Select(Text))} ms if not given", 0.01, 1000.0, "ms");
        var estimator = RuntimeOptions.Estimator();
        var command = new Command("paths", "Compare the estimated clock with the true clock while the minimum delays of a path change, in virtual time")
        {
            seeds, first, size, estimator,
        };
        command.SetAction((parsed, stop) =>
        {
            double[] sizesMs = parsed.GetValue(size) is { } only ? [only] : SizesMs;
            return Task.FromResult(Run(parsed.GetValue(estimator), sizesMs, [.. Enumerable.Range(parsed.GetValue(first), parsed.GetValue(seeds))], stop));
        });
        return command;
    }

    static int Run(string estimator, double[] sizesMs, int[] seeds, CancellationToken stop)
    {
        var missed = new List<string>();
        var table = new MarkdownTable(Console.Out, ["link", "change", .. sizesMs.Select(size => Text(size) + " ms")]);
        foreach (var link in LinkProfile.All)
        {
            PathRun[] Play(PathChange change, double sizeMs) =>
                [.. seeds.AsParallel().WithCancellation(stop).Select(seed => PathRun.Play(link, change, sizeMs, estimator, seed))];
            var undisturbed = Play(PathChange.None, 0);
            var own = new PathCell(link, PathChange.None, 0, undisturbed, undisturbed);
            table.AddCells([link.Name, PathChange.None.Name, .. sizesMs.Select(_ => own.ToString())]);
            foreach (var change in PathChange.All)
            {
                var cells = sizesMs.Select(size => new PathCell(link, change, size, Play(change, size), undisturbed)).ToList();
                table.AddCells([link.Name, change.Name, .. cells.Select(cell => cell.ToString())]);
                missed.AddRange(cells.SelectMany(cell => cell.Missed));
            }
        }

        Console.WriteLine();
        Console.WriteLine(
            "Cells: maximum error divided by half the difference between the changes in the two directions, maximum change of the skew, and share of "
            + "the time in which the error was within the stated ±; values of the worst run. Mean stated ± of all runs. All from 5 s after the "
            + "change on. **: exceeds a limit.");
        foreach (var line in missed) Console.Error.WriteLine("error: " + line);
        return missed.Count == 0 ? ExitStatus.Done : ExitStatus.Failed;
    }

    static string Text(double number) => number.ToString(CultureInfo.InvariantCulture);
}
