using BenchmarkDotNet.Reports;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>Limits of the measured times.</summary>
/// <remarks>
/// A headset at 60 Hz has 16.7 ms for everything. Seven joints at 100 Hz use less than 1 % of a core if one joint's sample needs less than 10 µs. The
/// command <c>cell</c> limits the frame time of a cell with many objects.
/// </remarks>
static class TimeLimits
{
    static readonly int Joints = SevenJointArm.JointNames.Length;

    /// <summary>Limits, each for one of <c>Count</c> equal parts of a method's work.</summary>
    static readonly (Type Benchmarks, string Method, string Subject, string Part, int Count, double Microseconds)[] All =
    [
        (typeof(SceneBenchmarks), nameof(SceneBenchmarks.Play), $"{SceneBenchmarks.Robots} robots", "display frame", 1, 1000),
        (typeof(BodyBenchmarks), nameof(BodyBenchmarks.At), "one tracked frame", "display frame", 1, 2),
        (typeof(SampleBenchmarks), nameof(SampleBenchmarks.SolveDefault), $"'{Predictors.Default}'", "joint sample", Joints, 10),
        (typeof(SampleBenchmarks), nameof(SampleBenchmarks.SolveDefaultAt100Hz), $"'{Predictors.Default}'", "joint sample", Joints, 10),
    ];

    /// <returns>A line that names the exceeded limit; null if the limits are met or if nothing was measured.</returns>
    public static string Exceeded(IEnumerable<Summary> summaries)
    {
        foreach (var report in summaries.SelectMany(summary => summary.Reports))
        {
            var method = report.BenchmarkCase.Descriptor.WorkloadMethod;
            if (report.ResultStatistics is not { } times) continue;
            foreach (var limit in All.Where(limit => method.DeclaringType == limit.Benchmarks && method.Name == limit.Method))
                if (times.Mean / 1000 / limit.Count is var needed && !(needed < limit.Microseconds))
                    return FormattableString.Invariant(
                        $"{limit.Subject}: {needed:0.0} µs per {limit.Part}; allowed: less than {limit.Microseconds} µs");
        }
        return null;
    }
}
