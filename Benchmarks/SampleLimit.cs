using BenchmarkDotNet.Reports;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>What the default predictor may take of a core: 70 µs for a joint's sample, so that seven joints at 100 Hz stay below 5 %.</summary>
static class SampleLimit
{
    const double Nanoseconds = 70e3;

    static readonly string[] Limited = [nameof(SampleBenchmarks.SolveDefault), nameof(SampleBenchmarks.SolveDefaultAt100Hz)];

    /// <returns>Why the measurements are not good enough, in one line; null when they are, or nothing of the kind was measured.</returns>
    public static string Exceeded(IEnumerable<Summary> summaries)
    {
        foreach (var report in summaries.SelectMany(summary => summary.Reports))
        {
            var method = report.BenchmarkCase.Descriptor.WorkloadMethod;
            if (method.DeclaringType != typeof(SampleBenchmarks) || !Limited.Contains(method.Name)) continue;
            if (report.ResultStatistics is { } times && !(times.Mean / SevenJointArm.JointNames.Length < Nanoseconds))
                return FormattableString.Invariant(
                    $"a joint's sample takes '{Predictors.Default}' {times.Mean / SevenJointArm.JointNames.Length / 1e3:0.0} µs; allowed is less than {Nanoseconds / 1e3:0} µs");
        }
        return null;
    }
}
