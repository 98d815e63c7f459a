using System.Globalization;
using System.Runtime.InteropServices;
using BenchmarkDotNet.Mathematics;
using BenchmarkDotNet.Reports;

namespace Nowpose.Benchmarks;

/// <summary>Writes the results as a Markdown table, with the speed relative to the naive frame, the share of a core, and the conditions.</summary>
static class ResultTable
{
    const double FrameNanoseconds = 1e9 / 60;

    public static void Write(IReadOnlyList<Summary> summaries, TextWriter to)
    {
        to.WriteLine();
        var reports = summaries.SelectMany(summary => summary.Reports).Where(report => !CostTable.Holds(report)).ToList();
        if (reports.Count > 0)
        {
            var table = new MarkdownTable(to, "", "mean", "allocated");
            foreach (var report in reports) table.AddCells(Row(report));
            to.WriteLine();
        }
        foreach (var summary in summaries) WriteRatios(summary, to);
        to.WriteLine(Conditions(summaries[0]));
    }

    static string[] Row(BenchmarkReport report)
    {
        var what = report.BenchmarkCase.Descriptor.WorkloadMethodDisplayInfo.Trim('\'');
        if (report.ResultStatistics == null) return [what, "failed", ""];
        var bytes = report.GcStats.GetBytesAllocatedPerOperation(report.BenchmarkCase);
        return [what, $"{Time(report.ResultStatistics.Mean)} ± {Time(report.ResultStatistics.StandardError)}", $"{bytes} B"];
    }

    // Compares with the fastest naive frame. The other naive frames take longer because of other programs, which would distort the ratio.
    static void WriteRatios(Summary summary, TextWriter to)
    {
        if (StatisticsOf(summary, nameof(SampleBenchmarks.SolveDefaultAt100Hz))?.Mean is { } samples)
            to.WriteLine(FormattableString.Invariant($"The default takes {samples * 100 / 1e9:0.0 %} of a core for seven joints at 100 Hz."));
        foreach (var method in new[] { nameof(SampleBenchmarks.SolveDefault), nameof(SampleBenchmarks.SolveDefaultAt100Hz) })
            if (StatisticsOf(summary, method)?.Mean is { } sample && StatisticsOf(summary, nameof(SampleBenchmarks.Solve))?.Mean is { } quadratic)
                to.WriteLine(FormattableString.Invariant(
                    $"{method}: {sample / quadratic:0} times the quadratic's, {sample / FrameNanoseconds:0.00 %} of a frame at 60 Hz."));
        if (StatisticsOf(summary, nameof(FrameBenchmarks.Tick))?.Mean is not { } frame) return;
        if (StatisticsOf(summary, nameof(FrameBenchmarks.Solve))?.Min is { } naive)
            to.WriteLine(Ratio(naive, frame, "the naive one"));
        if (StatisticsOf(summary, nameof(FrameBenchmarks.SolveOnOneThread))?.Min is { } oneThread)
            to.WriteLine(Ratio(oneThread, frame, "the naive one on one thread"));
    }

    static string Ratio(double naive, double frame, string what) => FormattableString.Invariant(
        $"A frame ({Time(frame)}) is {naive / frame:0} times faster than {what} at its fastest ({Time(naive)}).");

    static Statistics StatisticsOf(Summary summary, string method) => summary.Reports
        .FirstOrDefault(report => report.BenchmarkCase.Descriptor.WorkloadMethod.Name == method)?.ResultStatistics;

    static string Time(double nanoseconds) => nanoseconds < 1000
        ? string.Create(CultureInfo.InvariantCulture, $"{nanoseconds:0.0} ns")
        : string.Create(CultureInfo.InvariantCulture, $"{nanoseconds / 1000:0.00} µs");

    static string Conditions(Summary summary) => string.Create(CultureInfo.InvariantCulture,
        $"Mean ± standard error on {RuntimeInformation.FrameworkDescription}, "
        + $"{summary.HostEnvironmentInfo.CpuInfo.Value.ProcessorName}, {Environment.ProcessorCount} logical cores, "
        + $"{RuntimeInformation.OSDescription}, {DateTime.UtcNow:yyyy-MM-dd}.");
}
