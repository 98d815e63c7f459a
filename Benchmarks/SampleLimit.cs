using BenchmarkDotNet.Reports;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>Limits the cost of a joint's sample by the default predictor to 10 µs: seven joints at 100 Hz stay below 1 % of a core.</summary>
static class SampleLimit
{
    const double Nanoseconds = 10e3;

    static readonly string[] Limited = [nameof(SampleBenchmarks.SolveDefault), nameof(SampleBenchmarks.SolveDefaultAt100Hz)];

    /// <returns>The exceeded limit in one line; null if all limits are kept, or if none was measured.</returns>
    public static string Exceeded(IEnumerable<Summary> summaries)
    {
        foreach (var report in summaries.SelectMany(summary => summary.Reports))
        {
            var method = report.BenchmarkCase.Descriptor.WorkloadMethod;
            if (method.DeclaringType != typeof(SampleBenchmarks) || !Limited.Contains(method.Name)) continue;
            if (report.ResultStatistics is { } times && !(times.Mean / SevenJointArm.JointNames.Length < Nanoseconds))
                return FormattableString.Invariant(
                    $"a joint's sample takes '{Predictors.Default}' {times.Mean / SevenJointArm.JointNames.Length / 1e3:0.0} µs; allowed: less than {Nanoseconds / 1e3:0} µs");
        }
        return null;
    }
}
