using System.Text.Json;

namespace Nowpose.Benchmarks.Load;

/// <summary>Writes results as a table and as JSON.</summary>
static class LoadTable
{
    static readonly JsonSerializerOptions Snake = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower,
        NumberHandling = System.Text.Json.Serialization.JsonNumberHandling.AllowNamedFloatingPointLiterals,
    };

    public static void Write(IReadOnlyList<LoadResult> results, TextWriter to)
    {
        var table = new MarkdownTable(
            to, "headsets", "msg/s", "lost", "ended", "forward P50", "P99", "max ms", "sync error P95 µs", "memory MiB (± %)",
            "cores gateway + tool");
        foreach (var r in results)
            table.Add(
                $"{r.Headsets} × {r.RateHz} Hz | {r.MessagesPerSecond:0} | {r.Lost} | {r.Ended}",
                $"{r.ForwardP50Ms:0.00} | {r.ForwardP99Ms:0.00} | {r.ForwardMaxMs:0.0} | {r.SyncErrorP95Us:0} (truth ± {r.TruthBoundUs:0})",
                $"{r.MemoryMeanMib:0} (± {100 * r.MemoryDeviation:0.0}) | {r.GatewayCores:0.00} + {r.ToolCores:0.00}");
        to.WriteLine();
        to.WriteLine(JsonSerializer.Serialize(results, Snake));
    }
}
