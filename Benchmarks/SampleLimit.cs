using BenchmarkDotNet.Reports;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>
/// Limits the cost of one joint's sample with the default predictor to 10 µs. Seven joints at 100 Hz then use less than 1 % of a core.
/// </summary>
static class SampleLimit
{
    const double Nanoseconds = 10e3;

    static readonly string[] Limited = [nameof(SampleBenchmarks.SolveDefault), nameof(SampleBenchmarks.SolveDefaultAt100Hz)];

    /// <returns>A line that names the exceeded limit; null if the limit is met or if nothing was measured.</returns>
    public static string Exceeded(IEnumerable<Summary> summaries)
    {
        foreach (var report in summaries.SelectMany(summary => summary.Reports))
        {
            var method = report.BenchmarkCase.Descriptor.WorkloadMethod;
            if (method.DeclaringType != typeof(SampleBenchmarks) || !Limited.Contains(method.Name)) continue;
            if (report.ResultStatistics is not { } times) continue;
            var needed = times.Mean / SevenJointArm.JointNames.Length;
            if (!(needed < Nanoseconds))
                return FormattableString.Invariant(
                    $"'{Predictors.Default}' needs {needed / 1e3:0.0} µs per joint sample; allowed: less than {Nanoseconds / 1e3:0} µs");
        }
        return null;
    }
}
