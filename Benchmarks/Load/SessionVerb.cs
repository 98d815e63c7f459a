using System.CommandLine;
using Nowpose.Gateway.Options;

namespace Nowpose.Benchmarks.Load;

/// <summary>sessions: measures how much memory a gateway keeps after headsets have disconnected.</summary>
static class SessionVerb
{
    /// <summary>Maximum relative growth of the memory from the third to the last quarter of the run.</summary>
    const double MaxGrowth = 0.03;

    const int ConnectingAtOnce = 8;

    public static Command Create()
    {
        var headsets = NumberOption.Create("--headsets", "Number of headsets that are connected at the same time", 200, 1, 2000, "");
        var rounds = NumberOption.Create("--rounds", "Number of times that all headsets connect and disconnect", 40, 8, 10_000, "");
        var milliseconds = NumberOption.Create("--stay-ms", "Duration of each connection", 1000, 0, 3_600_000, "ms");
        var command = new Command("sessions", "Run a gateway in a separate process while headsets connect and disconnect; its memory must stop growing")
        {
            headsets, rounds, milliseconds,
        };
        command.SetAction((parsed, stop) => MeasureAsync(
            parsed.GetValue(headsets), parsed.GetValue(rounds), TimeSpan.FromMilliseconds(parsed.GetValue(milliseconds)), stop));
        return command;
    }

    static async Task<int> MeasureAsync(int headsets, int rounds, TimeSpan stay, CancellationToken stop)
    {
        const double RateHz = 20;
        // While headsets connect, the gateway may still have the connections of the previous round.
        using var gateway = await GatewayProcess.StartAsync(RateHz, headsets * 4);
        var truth = ControlTruth.Measure(gateway.Sync);
        using var http = new HttpClient();
        var samples = new List<MemorySample> { await ReadAsync(gateway, http, 0) };
        for (var round = 1; round <= rounds; round++)
        {
            await RunSessionsAsync(gateway, truth, headsets, RateHz, stay, stop);
            samples.Add(await ReadAsync(gateway, http, round * headsets));
            Console.Error.WriteLine(FormattableString.Invariant($"{samples[^1].Sessions} sessions: {samples[^1].ResidentMiB:0.0} MiB"));
        }

        Write(samples, rounds);
        return Judge(samples, rounds);
    }

    // Runs sessions: each headset opens both connections, receives samples, sends diagnostics and disconnects.
    static async Task RunSessionsAsync(GatewayProcess gateway, ControlTruth truth, int count, double rateHz, TimeSpan stay, CancellationToken stop)
    {
        var latencies = new LatencyCounts();
        var headsets = Enumerable.Range(0, count).Select(i => new LeanHeadset($"session {i}", rateHz, latencies, truth)).ToList();
        foreach (var some in headsets.Chunk(ConnectingAtOnce))
        {
            stop.ThrowIfCancellationRequested();
            await Task.WhenAll(some.Select(headset => headset.OpenAsync(gateway)));
            foreach (var headset in some) _ = headset.RunAsync();
        }

        await Task.Delay(stay, stop);
        foreach (var headset in headsets) headset.Dispose();
    }

    static async Task<MemorySample> ReadAsync(GatewayProcess gateway, HttpClient http, int sessions)
    {
        var metrics = await http.GetStringAsync(new Uri($"http://{gateway.WebSocket}/metrics"));
        return new MemorySample(sessions, gateway.ResidentBytes, Metric(metrics, "nowpose_managed_memory_bytes"));
    }

    static double Metric(string metrics, string name) => double.Parse(
        metrics.Split('\n').Single(line => line.StartsWith(name + " ", StringComparison.Ordinal))[(name.Length + 1)..],
        System.Globalization.CultureInfo.InvariantCulture);

    static void Write(List<MemorySample> samples, int rounds)
    {
        var table = new MarkdownTable(Console.Out, "sessions so far", "resident MiB", "managed MiB");
        foreach (var sample in samples.Where((_, i) => i % Math.Max(1, rounds / 8) == 0))
            table.Add($"{sample.Sessions} | {sample.ResidentMiB:0.0} | {sample.ManagedMiB:0.0}");
    }

    static int Judge(List<MemorySample> samples, int rounds)
    {
        var quarter = rounds / 4;
        var last = samples.TakeLast(quarter).Average(sample => sample.ResidentMiB);
        var before = samples.SkipLast(quarter).TakeLast(quarter).Average(sample => sample.ResidentMiB);
        var growth = (last / before) - 1;
        Console.WriteLine();
        Console.WriteLine(FormattableString.Invariant($"last quarter {last:0.0} MiB, the quarter before {before:0.0} MiB ({100 * growth:+0.0;-0.0} %)"));
        if (growth <= MaxGrowth) return ExitStatus.Done;
        Console.Error.WriteLine(FormattableString.Invariant($"error: the memory still grows by {100 * growth:0.0} %; allowed: {100 * MaxGrowth:0} %"));
        return ExitStatus.Failed;
    }
}

/// <summary>The memory of a gateway after a number of sessions.</summary>
readonly record struct MemorySample(int Sessions, double ResidentBytes, double ManagedBytes)
{
    const double Mebibyte = 1024 * 1024;

    public double ResidentMiB => ResidentBytes / Mebibyte;
    public double ManagedMiB => ManagedBytes / Mebibyte;
}
