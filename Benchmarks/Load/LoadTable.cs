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
        to.WriteLine("| headsets | msg/s | lost | ended | forward P50 | P99 | max ms | sync error P95 µs | memory MiB (± %) | cores gateway + tool |");
        to.WriteLine("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
        foreach (var result in results)
            to.WriteLine(FormattableString.Invariant(
                $"| {result.Headsets} × {result.RateHz} Hz | {result.MessagesPerSecond:0} | {result.Lost} | {result.Ended} ")
                + FormattableString.Invariant($"| {result.ForwardP50Ms:0.00} | {result.ForwardP99Ms:0.00} | {result.ForwardMaxMs:0.0} ")
                + FormattableString.Invariant($"| {result.SyncErrorP95Us:0} (truth ± {result.TruthBoundUs:0}) ")
                + FormattableString.Invariant($"| {result.MemoryMeanMib:0} (± {100 * result.MemoryDeviation:0.0}) ")
                + FormattableString.Invariant($"| {result.GatewayCores:0.00} + {result.ToolCores:0.00} |"));
        to.WriteLine();
        to.WriteLine(JsonSerializer.Serialize(results, Snake));
    }
}
