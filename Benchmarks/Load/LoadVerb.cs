using System.CommandLine;
using Nowpose.Gateway.Options;

namespace Nowpose.Benchmarks.Load;

/// <summary>gateway: measures a gateway with hundreds of headsets.</summary>
static class LoadVerb
{
    /// <summary>
    /// Upper limit of the number of additional connections: those of the sampled headset, of a headset that stops reading (new and previous
    /// connection), and of the measurement of the true time.
    /// </summary>
    const int OtherConnections = 16;

    const int MaxConnections = 10_000;
    const double Growth = 1.25;
    static readonly TimeSpan StepLength = TimeSpan.FromSeconds(20);

    public static Command Create()
    {
        var headsets = NumberOption.Create("--headsets", "Number of headsets, with two connections each", 200, 1, 4000, "");
        var rate = NumberOption.Create("--rate-hz", "Samples per second", 50.0, 1, 1000, "Hz");
        var seconds = NumberOption.Create("--seconds", "Duration of the measurement, after the warm-up", 300, 1, 86_400, "s");
        var warmUp = NumberOption.Create("--warm-up-s", "Duration of the warm-up, until the gateway's memory has its final size", 10, 1, 600, "s");
        var breaks = SwitchOption.Create(
            "--until-it-breaks", "Afterwards, increase the number of headsets by a quarter every 20 s until P99 reaches 5 ms or samples are lost");
        var compared = TextOption.Create(
            "--compare", "Path of another build's Nowpose.Gateway.dll; compare the P99 of both builds in alternating runs", "PATH");
        var rounds = NumberOption.Create("--rounds", "Number of runs of each build with --compare", 5, 1, 100, "");
        var command = new Command(
            "gateway", "Run a gateway in a separate process with many headsets, which share this machine's processors with it")
        {
            headsets, rate, seconds, warmUp, breaks, compared, rounds,
        };
        command.SetAction(async (parsed, stop) =>
        {
            var settings = new LoadSettings(
                parsed.GetValue(headsets), parsed.GetValue(rate), TimeSpan.FromSeconds(parsed.GetValue(seconds)),
                TimeSpan.FromSeconds(parsed.GetValue(warmUp)));
            if (parsed.GetValue(compared) is { } program) return await CompareAsync(settings, program, parsed.GetValue(rounds), stop);
            var results = await MeasureAsync(settings, parsed.GetValue(breaks), stop);
            LoadTable.Write(results, Console.Out);
            if (results.Count > 1) WriteBreak(results);
            return Judge(results[0]);
        });
        return command;
    }

    static async Task<int> CompareAsync(LoadSettings settings, string program, int rounds, CancellationToken stop)
    {
        if (!File.Exists(program)) throw new InputException($"--compare: {program} does not exist; give the path of the other build's Nowpose.Gateway.dll");
        var results = new List<(LoadResult Own, LoadResult Other)>();
        for (var round = 1; round <= rounds; round++)
        {
            var isOwnFirst = round % 2 == 1;
            var first = await MeasureAsync(settings, isOwnFirst ? null : program, stop);
            var second = await MeasureAsync(settings, isOwnFirst ? program : null, stop);
            results.Add(isOwnFirst ? (first, second) : (second, first));
            Console.Error.WriteLine(FormattableString.Invariant(
                $"round {round} of {rounds}: P99 {results[^1].Own.ForwardP99Ms:0.00} ms, other build {results[^1].Other.ForwardP99Ms:0.00} ms"));
        }

        var comparison = new LoadComparison(results);
        comparison.Write(Console.Out);
        return comparison.Ratio <= LoadComparison.MaxRatio ? ExitStatus.Done : ExitStatus.Failed;
    }

    static async Task<LoadResult> MeasureAsync(LoadSettings settings, string program, CancellationToken stop)
    {
        using var run = await LoadRun.StartAsync(settings.RateHz, settings.Headsets + OtherConnections, program);
        return await run.MeasureAsync(settings, stop);
    }

    static async Task<List<LoadResult>> MeasureAsync(LoadSettings settings, bool untilItBreaks, CancellationToken stop)
    {
        using var run = await LoadRun.StartAsync(
            settings.RateHz, untilItBreaks ? MaxConnections : settings.Headsets + OtherConnections);
        var results = new List<LoadResult> { await run.MeasureAsync(settings, stop) };
        while (untilItBreaks && results[^1].Break == null)
        {
            var more = (int)Math.Ceiling(results[^1].Headsets * Growth);
            if (more + OtherConnections > MaxConnections) break;
            results.Add(await run.MeasureAsync(settings with { Headsets = more, Length = StepLength }, stop));
        }

        return results;
    }

    static int Judge(LoadResult result)
    {
        var wrong = new List<string>();
        if (result.Break != null) wrong.Add(result.Break);
        if (!result.IsSyncGood) wrong.Add(FormattableString.Invariant($"sync error P95 {result.SyncErrorP95Us:0} µs"));
        if (!result.IsMemoryFlat) wrong.Add(FormattableString.Invariant($"memory ± {100 * result.MemoryDeviation:0.0} %"));
        if (result.Refused > 0) wrong.Add($"{result.Refused} messages refused");
        if (wrong.Count == 0) return ExitStatus.Done;
        Console.Error.WriteLine("error: " + string.Join(", ", wrong));
        return ExitStatus.Failed;
    }

    static void WriteBreak(IReadOnlyList<LoadResult> results)
    {
        var last = results[^1];
        Console.Error.WriteLine(last.Break == null
            ? $"within the limits with {last.Headsets} headsets"
            : $"exceeds a limit with {last.Headsets} headsets ({last.Break}), not with {results[^2].Headsets}");
    }
}
