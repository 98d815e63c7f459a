using BenchmarkDotNet.Reports;

namespace Nowpose.Benchmarks;

/// <summary>
/// Limits the frame time of a scene with many robots, and the time of one tracked frame. A headset at 60 Hz has 16.7 ms for everything. The command
/// <c>cell</c> limits the frame time of a cell with many objects.
/// </summary>
static class FrameLimit
{
    static readonly (Type Benchmarks, string Method, string Subject, double Microseconds)[] Limits =
    [
        (typeof(SceneBenchmarks), nameof(SceneBenchmarks.Play), $"{SceneBenchmarks.Robots} robots", 1000),
        (typeof(BodyBenchmarks), nameof(BodyBenchmarks.At), "one tracked frame", 2),
    ];

    /// <returns>A line that names the exceeded limit; null if the limits are met or if nothing was measured.</returns>
    public static string Exceeded(IEnumerable<Summary> summaries)
    {
        foreach (var report in summaries.SelectMany(summary => summary.Reports))
        {
            var method = report.BenchmarkCase.Descriptor.WorkloadMethod;
            if (report.ResultStatistics is not { } times) continue;
            foreach (var limit in Limits)
                if (method.DeclaringType == limit.Benchmarks && method.Name == limit.Method && !(times.Mean < 1000 * limit.Microseconds))
                    return FormattableString.Invariant(
                        $"{limit.Subject}: {times.Mean / 1000:0.0} µs per display frame; allowed: less than {limit.Microseconds} µs");
        }
        return null;
    }
}
