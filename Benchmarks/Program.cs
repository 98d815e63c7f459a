using BenchmarkDotNet.Running;
using Nowpose.Benchmarks;
using Nowpose.Benchmarks.Ablation;
using Nowpose.Benchmarks.Cell;
using Nowpose.Benchmarks.Comparison;
using Nowpose.Benchmarks.Links;
using Nowpose.Benchmarks.Load;
using Nowpose.Benchmarks.Paths;
using Nowpose.Benchmarks.Sensitivity;

if (args is ["ablation", ..])
    return await AblationVerb.RunAsync(args);

if (args is ["cell", ..])
    return await CellVerb.RunAsync(args);

if (args is ["gateway", ..])
    return await LoadVerb.RunAsync(args);

if (args is ["links", ..])
    return await LinksVerb.RunAsync(args);

if (args is ["paper", ..])
    return await PaperVerb.RunAsync(args);

if (args is ["paths", ..])
    return await PathsVerb.RunAsync(args);

if (args is ["sensitivity", ..])
    return await SensitivityVerb.RunAsync(args);

if (args is ["sessions", ..])
    return await SessionVerb.RunAsync(args);

if (args is ["tune"])
{
    Tuning.Run(Console.Out);
    return 0;
}

// BenchmarkDotNet searches for the project below the current directory, which can be any folder.
Environment.CurrentDirectory = Path.GetFullPath("../../..", AppContext.BaseDirectory);

// Without arguments, all benchmarks run. BenchmarkDotNet's arguments, such as --filter *Frame*, select some of them.
var summaries = BenchmarkSwitcher.FromTypes([typeof(FrameBenchmarks), typeof(SampleBenchmarks), typeof(PredictorBenchmarks), typeof(ExchangeBenchmarks),
        typeof(SceneBenchmarks), typeof(BodyBenchmarks)])
    .Run(args.Length > 0 ? args : ["--filter", "*"], MeasurementSettings.Create())
    .ToList();
if (summaries.Count == 0) return 1;

ResultTable.Write(summaries, Console.Out);
ComparisonTable.Write(CostTable.Of(summaries), Console.Out);
var tooSlow = FrameLimit.Exceeded(summaries) ?? SampleLimit.Exceeded(summaries);
if (tooSlow != null)
{
    Console.Error.WriteLine("error: " + tooSlow);
    return 1;
}
return summaries.All(summary => summary.Reports.Length > 0 && summary.Reports.All(report => report.Success)) ? 0 : 1;
