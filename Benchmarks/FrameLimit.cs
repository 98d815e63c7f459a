using BenchmarkDotNet.Reports;

namespace Nowpose.Benchmarks;

/// <summary>Limit of the frame time for a scene with many robots: a headset at 60 Hz has 16.7 ms for everything.</summary>
static class FrameLimit
{
    const double Nanoseconds = 1e6;

    /// <returns>The exceeded limit in one line; null if all limits are kept, or if none was measured.</returns>
    public static string Exceeded(IEnumerable<Summary> summaries)
    {
        foreach (var report in summaries.SelectMany(summary => summary.Reports))
        {
            var method = report.BenchmarkCase.Descriptor.WorkloadMethod;
            if (method.DeclaringType != typeof(SceneBenchmarks) || method.Name != nameof(SceneBenchmarks.Play)) continue;
            if (report.ResultStatistics is { } times && !(times.Mean < Nanoseconds))
                return FormattableString.Invariant($"a frame of {SceneBenchmarks.Robots} robots takes {times.Mean / 1e6:0.00} ms; allowed: less than 1 ms");
        }
        return null;
    }
}
