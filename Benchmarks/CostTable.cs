using BenchmarkDotNet.Reports;
using Nowpose.Benchmarks.Comparison;

namespace Nowpose.Benchmarks;

/// <summary>The measured costs of each candidate, per sample and per frame of one joint.</summary>
sealed class CostTable
{
    readonly Dictionary<(string ComparedPredictor, string Method), Cost> _costs = [];

    /// <summary>Gets whether a measurement belongs to this table.</summary>
    public static bool Holds(BenchmarkReport report) => report.BenchmarkCase.Descriptor.Type == typeof(PredictorBenchmarks);

    public static CostTable Of(IEnumerable<Summary> summaries)
    {
        var table = new CostTable();
        foreach (var report in summaries.SelectMany(summary => summary.Reports).Where(Holds))
            if (report.ResultStatistics is { } times)
                table._costs[((string)report.BenchmarkCase.Parameters[nameof(PredictorBenchmarks.Predictor)],
                    report.BenchmarkCase.Descriptor.WorkloadMethod.Name)] =
                    new Cost(times.Median, report.GcStats.GetBytesAllocatedPerOperation(report.BenchmarkCase) ?? 0);
        return table;
    }

    public bool IsEmpty => _costs.Count == 0;

    public Cost? Sample(ComparedPredictor candidate) => Find(candidate, nameof(PredictorBenchmarks.Add));

    public Cost? Frame(ComparedPredictor candidate) => Find(candidate, nameof(PredictorBenchmarks.At));

    Cost? Find(ComparedPredictor candidate, string method) => _costs.TryGetValue((candidate.Name, method), out var cost) ? cost : null;
}
