using BenchmarkDotNet.Reports;

namespace Nowpose.Benchmarks;

/// <summary>Limits the frame time of a scene with many robots. A headset at 60 Hz has 16.7 ms for everything.</summary>
static class FrameLimit
{
    const double Nanoseconds = 1e6;

    /// <returns>A line that names the exceeded limit; null if the limit is met or if nothing was measured.</returns>
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
