using System.CommandLine;
using BenchmarkDotNet.Running;
using Nowpose.Benchmarks;
using Nowpose.Benchmarks.Ablation;
using Nowpose.Benchmarks.Cell;
using Nowpose.Benchmarks.Comparison;
using Nowpose.Benchmarks.Links;
using Nowpose.Benchmarks.Load;
using Nowpose.Benchmarks.Paths;
using Nowpose.Benchmarks.Sensitivity;
using Nowpose.Gateway.Options;

var tune = new Command("tune", "Find the constants of the other filters in the comparison of the predictors");
tune.SetAction(_ => Tuning.Run(Console.Out));

// The arguments of BenchmarkDotNet, such as --filter *Frame*, start with a hyphen. They select some of the benchmarks; without arguments, all run.
if (args is [[not '-', ..], ..])
    return await Invocation.RunAsync(
        Invocation.Root(
            "nowpose-benchmarks", "Benchmarks of Nowpose.", AblationVerb.Create(), CellVerb.Create(), LoadVerb.Create(), LinksVerb.Create(),
            PaperVerb.Create(), PathsVerb.Create(), SensitivityVerb.Create(), SessionVerb.Create(), tune),
        args);

// BenchmarkDotNet searches for the project below the current directory, which can be any folder.
Environment.CurrentDirectory = Path.GetFullPath("../../..", AppContext.BaseDirectory);

var summaries = BenchmarkSwitcher.FromTypes([typeof(FrameBenchmarks), typeof(SampleBenchmarks), typeof(PredictorBenchmarks), typeof(ExchangeBenchmarks),
        typeof(SceneBenchmarks), typeof(BodyBenchmarks)])
    // A job in the arguments, such as --job Dry, replaces the settings.
    .Run(args.Length > 0 ? args : ["--filter", "*"], args.Contains("--job") ? null : MeasurementSettings.Create())
    .ToList();
if (summaries.Count == 0) return 1;

ResultTable.Write(summaries, Console.Out);
ComparisonTable.Write(CostTable.Of(summaries), Console.Out);
var tooSlow = TimeLimits.Exceeded(summaries);
if (tooSlow != null)
{
    Console.Error.WriteLine("error: " + tooSlow);
    return 1;
}
return summaries.All(summary => summary.Reports.Length > 0 && summary.Reports.All(report => report.Success)) ? 0 : 1;
